#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "core/scene/scenes.hpp"
#include "core/shadow/shadow_settings.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_controls.hpp"
#include "ui/widgets/technique_combo.hpp"

namespace momentscope::ui {

namespace {

constexpr float LABEL_WIDTH = 13.5f;  // font heights

void wide_label(const char* text) {
    label(text, LABEL_WIDTH);
    ImGui::SetNextItemWidth(-1);
}

void draw_scene_combo(const Ui& ui, ExplorerState& state) {
    const std::string shown = state.ray ? "a view ray without a scene" : state.scene;
    const bool open = ImGui::BeginCombo("##scene", shown.c_str());
    ui.record_widget_rect("controls.scene");
    tooltip("The scene. To open a mesh file, use File > Open mesh.", "--scene");
    if (!open) return;
    for (const SceneEntry& entry : scene_entries()) {
        if (ImGui::Selectable(entry.id, !state.ray && state.scene == entry.id)) choose_scene(state, entry.id);
        ui.record_widget_rect(fmt::format("controls.scene.{}", entry.id));
        tooltip(entry.description);
    }
    ImGui::EndCombo();
}

void draw_compared_combo(const Ui& ui, ExplorerState& state) {
    std::string shown;
    for (const Technique* technique : state.compared)
        shown += fmt::format("{}{}", shown.empty() ? "" : ", ", technique->id);
    const bool open = ImGui::BeginCombo("##compared", shown.empty() ? "none" : shown.c_str(),
                                        ImGuiComboFlags_HeightLargest);
    ui.record_widget_rect("controls.compared");
    tooltip("Further techniques whose reconstructions the plot shows.");
    if (!open) return;
    for (const Technique& row : techniques()) {
        if (!has_function(row)) continue;
        bool on = std::ranges::find(state.compared, &row) != state.compared.end();
        if (ImGui::Checkbox(technique_label(row).c_str(), &on)) {
            if (on)
                state.compared.push_back(&row);
            else
                std::erase(state.compared, &row);
        }
        ui.record_widget_rect(fmt::format("controls.compared.{}", row.id));
        tooltip(row.description, row.source);
    }
    ImGui::EndCombo();
}

// Experts see all parameters. Others see an expert's parameter if it acts, or if the open lesson needs it.
bool is_shown(const Workspace& w, const Parameter& row) {
    if (w.settings.expert || w.to_type == row.id) return true;
    if (std::ranges::find(EXPERT_PARAMETERS, row.id) == EXPERT_PARAMETERS.end()) return true;
    const auto place = w.course.open_step(w.state);
    return w.state.parameters[row.id] != ParameterValues()[row.id] ||
           (place &&
            (place->lesson->all_controls || highlights(*place->lesson, std::string("parameter.") + row.key)));
}

// The parameters of the technique, in the order of the registry.
std::vector<const Parameter*> shown_parameters(const Workspace& w) {
    const ExplorerState& state = w.state;
    std::vector<const Parameter*> rows;
    for (const Parameter& row : parameters()) {
        const bool of_mesh = row.id == ParameterId::opacity && !is_builtin_scene(state.scene) && !state.ray;
        if ((state.technique->uses(row.id) || of_mesh) && is_shown(w, row)) rows.push_back(&row);
    }
    return rows;
}

// Choices, two in a row where the panel is wide enough.
void draw_choices(const Ui& ui, std::span<const Parameter* const> rows, ExplorerState& state,
                  Status& status) {
    constexpr float CELL_LABEL_WIDTH = 10.4f, LEAST_WIDTH = 35.0f;  // font heights
    const bool wide = rows.size() > 1 && ImGui::GetContentRegionAvail().x >= LEAST_WIDTH * em();
    if (!wide) {
        for (const Parameter* row : rows)
            draw_parameter_control(ui, *row, *state.technique, LABEL_WIDTH * em(), false, state.parameters,
                                   status);
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0, 0.5f * ImGui::GetStyle().ItemSpacing.y));
    if (ImGui::BeginTable("choices", 3, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableSetupColumn("left");
        ImGui::TableSetupColumn("gap", ImGuiTableColumnFlags_WidthFixed, em());
        ImGui::TableSetupColumn("right");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i % 2 == 0) ImGui::TableNextRow();
            ImGui::TableSetColumnIndex(i % 2 == 0 ? 0 : 2);
            draw_parameter_control(ui, *rows[i], *state.technique, CELL_LABEL_WIDTH * em(), false,
                                   state.parameters, status);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

// One control per parameter of the technique. That of w.to_type becomes a text field now.
void draw_technique_controls(const Ui& ui, Workspace& w) {
    ExplorerState& state = w.state;
    Status& status = w.status;
    const std::vector<const Parameter*> rows = shown_parameters(w);
    const std::optional<ParameterId> to_type = std::exchange(w.to_type, std::nullopt);
    const auto is_choice = [](const Parameter* row) { return row->scale == Scale::choice; };
    for (const Parameter* row : rows)
        if (!is_choice(row))
            draw_parameter_control(ui, *row, *state.technique, LABEL_WIDTH * em(), to_type == row->id,
                                   state.parameters, status);
    std::vector<const Parameter*> choices;
    std::ranges::copy_if(rows, std::back_inserter(choices), is_choice);
    draw_choices(ui, choices, state, status);
    if (rows.empty()) ImGui::TextDisabled("This technique has no parameters.");
}

// The controls that apply to all techniques.
void draw_picture_controls(const Ui& ui, Workspace& w) {
    ExplorerState& state = w.state;
    if (state.ray) return;  // a view ray has no picture
    ImGui::Spacing();
    for (const ParameterId id : PICTURE_PARAMETERS)
        if (id != ParameterId::shadows && is_shown(w, parameter(id)))
            draw_parameter_control(ui, parameter(id), *state.technique, LABEL_WIDTH * em(), false,
                                   state.parameters, w.status);
}

void draw_shadow_controls(const Ui& ui, const ShownScene& scene, ExplorerState& state, Status& status) {
    if (state.ray) return;
    ImGui::Spacing();
    const Configuration of_light = light_configuration(state.parameters);
    const Light& light = scene.scene().light;
    const auto automatic = [&](ParameterId id) -> std::optional<float> {
        if (id == ParameterId::light_azimuth) return light.azimuth;
        if (id == ParameterId::light_elevation) return light.elevation;
        if (id == ParameterId::light_distance) return scene.light_distance();
        return std::nullopt;
    };
    const auto draw = [&](ParameterId id) {
        draw_parameter_control(ui, parameter(id), *of_light.technique, LABEL_WIDTH * em(), false,
                               state.parameters, status, automatic(id));
    };
    draw(ParameterId::shadows);
    if (!has_shadows(state.parameters)) return;
    for (const ParameterId id : SHADOW_PARAMETERS) draw(id);
    ImGui::Spacing();
}

void draw_expert_switch(const Ui& ui, Settings& settings) {
    ImGui::Spacing();
    if (ImGui::Button(settings.expert ? "fewer controls" : "all controls"))
        settings.expert = !settings.expert;
    ui.record_widget_rect("controls.expert");
    tooltip(
        settings.expert
            ? "Shows only the controls that most people need. What differs from its default stays."
            : "Also shows solver, factor, accumulation, presets, estimate, order of submission, tone map and tuning.",
        "It is kept for the next start.");
}

}  // namespace

// If the plot shows the light's ray, the controls of the light come first.
void draw_controls_panel(const Ui& ui, Workspace& w) {
    ExplorerState& state = w.state;
    const bool light_first = seen_from_light(state);
    if (light_first) draw_shadow_controls(ui, w.scene, state, w.status);
    wide_label("scene");
    draw_scene_combo(ui, state);
    wide_label("technique");
    draw_technique_combo(ui, "controls.technique",
                         "The technique that draws the picture and the orange curve; 1 to 9 choose one.",
                         "--technique", state.technique);
    if (w.settings.expert || !state.compared.empty()) {
        wide_label("also plot");
        draw_compared_combo(ui, state);
    }
    ImGui::Spacing();
    draw_technique_controls(ui, w);
    if (w.settings.expert || w.tuning.busy()) {
        if (w.tuning.draw(ui, state)) w.tuning.start(state, w.scene.scene(), w.picture.renderer(), w.status);
    }
    draw_picture_controls(ui, w);
    if (!light_first) draw_shadow_controls(ui, w.scene, state, w.status);
    draw_expert_switch(ui, w.settings);
}

}  // namespace momentscope::ui
