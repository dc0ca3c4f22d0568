#include <fmt/format.h>

#include <algorithm>

#include "core/scene/scenes.hpp"
#include "core/shadow/shadow_settings.hpp"
#include "ui/parameter_controls.hpp"
#include "ui/side_panels.hpp"
#include "ui/technique_combo.hpp"

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

}  // namespace

void draw_control_panel(const Ui& ui, OrderedAccess access, ExplorerState& state,
                        std::optional<ParameterId>& to_type, std::string& message) {
    wide_label("scene");
    draw_scene_combo(ui, state);
    wide_label("technique");
    draw_technique_combo(ui, "controls.technique", access,
                         "The technique that draws the picture and the orange curve; 1 to 9 choose one.",
                         "--technique", state.technique);
    wide_label("also plot");
    draw_compared_combo(ui, state);
    ImGui::Spacing();
    bool any = false;
    for (const Parameter& row : parameters()) {
        const bool of_mesh = row.id == ParameterId::opacity && !is_builtin_scene(state.scene) && !state.ray;
        if (!state.technique->uses(row.id) && !of_mesh) continue;
        draw_parameter_control(ui, row, *state.technique, LABEL_WIDTH * em(), to_type == row.id,
                               state.parameters, message);
        any = true;
    }
    to_type.reset();
    if (!any) ImGui::TextDisabled("This technique has no parameters.");
}

void draw_picture_controls(const Ui& ui, ExplorerState& state, std::string& message) {
    if (state.ray) return;  // a view ray has no picture
    ImGui::Spacing();
    for (const ParameterId id : PICTURE_PARAMETERS)
        if (id != ParameterId::shadows)
            draw_parameter_control(ui, parameter(id), *state.technique, LABEL_WIDTH * em(), false,
                                   state.parameters, message);
}

void draw_shadow_controls(const Ui& ui, const Light& light, float distance, ExplorerState& state,
                          std::string& message) {
    if (state.ray) return;
    ImGui::Spacing();
    const Configuration of_light = light_configuration(state.parameters);
    const auto automatic = [&](ParameterId id) -> std::optional<float> {
        if (id == ParameterId::light_azimuth) return light.azimuth;
        if (id == ParameterId::light_elevation) return light.elevation;
        if (id == ParameterId::light_distance) return distance;
        return std::nullopt;
    };
    const auto draw = [&](ParameterId id) {
        draw_parameter_control(ui, parameter(id), *of_light.technique, LABEL_WIDTH * em(), false,
                               state.parameters, message, automatic(id));
    };
    draw(ParameterId::shadows);
    if (!has_shadows(state.parameters)) return;
    for (const ParameterId id : SHADOW_PARAMETERS) draw(id);
    ImGui::Spacing();
}

}  // namespace momentscope::ui
