#include <fmt/format.h>

#include <algorithm>

#include "ui/commands/commands.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/technique_combo.hpp"

namespace momentscope::ui {

namespace {

void draw_modes(const Ui& ui, CompareState& compare) {
    constexpr struct {
        CompareMode mode;
        const char* name;
        const char* id;  // part of the ids of the command and of the control
    } MODES[] = {{CompareMode::wipe, "wipe", "wipe"},
                 {CompareMode::difference, "difference", "difference"},
                 {CompareMode::false_color, "false colour", "false_color"},
                 {CompareMode::uncertainty, "left open", "uncertainty"}};
    label("show");
    if (toggle_button("picture", compare.mode == CompareMode::off)) compare.mode = CompareMode::off;
    ui.record_widget_rect("comparison.off");
    tooltip("Shows only the picture; hold G to flip to the reference.");
    for (const auto& row : MODES) {
        ImGui::SameLine(0, 0.2f * em());
        if (toggle_button(row.name, compare.mode == row.mode)) compare.mode = row.mode;
        ui.record_widget_rect(fmt::format("comparison.{}", row.id));
        const Command& command = require_command(fmt::format("compare.{}", row.id));
        tooltip(command.help, command.keys.front());
    }
}

// Draws the controls of the current mode.
void draw_mode_controls(const Ui& ui, CompareState& compare) {
    if (compare.mode == CompareMode::wipe) {
        label("");
        if (ImGui::Button("swap sides")) compare.swapped = !compare.swapped;
        ui.record_widget_rect("comparison.swap");
        tooltip("Exchanges the sides of the reference and the picture.", "Shift+W");
    } else if (compare.mode != CompareMode::off) {
        label("amplify");
        ImGui::SetNextItemWidth(14 * em());
        ImGui::SliderFloat("##gain", &compare.gain, MIN_GAIN, MAX_GAIN, "× %.3g",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        ui.record_widget_rect("comparison.gain");
        tooltip("The factor by which the picture amplifies what it shows; the numbers stay as they are.",
                "1 to 64; Ctrl+click to type");
    }
}

void draw_number(const std::string& text, bool fresh) {
    ImGui::TableNextColumn();
    if (fresh)
        ImGui::TextUnformatted(text.c_str());
    else
        ImGui::TextDisabled("%s", text.c_str());
}

void draw_metric(const Ui& ui, const MetricRow& row, const char* name, Comparison& comparison,
                 ExplorerState& state) {
    CompareState& compare = state.compare;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (ImGui::Selectable(name, compare.metric == row.id, ImGuiSelectableFlags_SpanAllColumns))
        compare.metric = row.id;
    ui.record_widget_rect(fmt::format("comparison.metric.{}", row.key));
    tooltip(fmt::format("{} Click to choose it for false colour and the worst pixel.", row.help), row.source);
    const MetricResult* result = comparison.result(row.id);
    const bool fresh = comparison.is_fresh(row.id);
    if (result == nullptr) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("computing…");
        return;
    }
    draw_number(fmt::format("{:.4g}", result->mean), fresh);
    const PixelRegion region = pixels_of(compare.region, comparison.size());
    draw_number(compare.region ? fmt::format("{:.4g}", comparison.mean_of(*result, region)) : "–", fresh);
    draw_number(result->most > 0
                    ? fmt::format("{:.4g} at {}, {}", result->most, result->worst.x, result->worst.y)
                    : "0 everywhere",
                fresh);
}

// Uses short names if there is little space.
void draw_metrics(const Ui& ui, Comparison& comparison, ExplorerState& state) {
    const bool narrow = ImGui::GetContentRegionAvail().x < 36 * em();
    if (!ImGui::BeginTable("metrics", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) return;
    const float widths[] = {narrow ? 4.0f : 12.0f, 5.5f, 5.5f};
    const char* names[] = {"metric", "picture", "region"};
    for (std::size_t i = 0; i < std::size(names); ++i)
        ImGui::TableSetupColumn(names[i], ImGuiTableColumnFlags_WidthFixed, widths[i] * em());
    ImGui::TableSetupColumn("greatest", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    for (const MetricRow& row : metrics())
        draw_metric(ui, row, narrow ? row.symbol : row.name, comparison, state);
    ImGui::EndTable();
    const bool stale =
        std::ranges::any_of(metrics(), [&](const MetricRow& row) { return !comparison.is_fresh(row.id); });
    ImGui::TextDisabled("%s", stale ? "computing…" : "");  // always takes one line, so that nothing jumps
}

bool draw_actions(const Ui& ui, Comparison& comparison, CompareState& compare) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const bool asked = ImGui::Button("next worst pixel");
    ui.record_widget_rect("comparison.next_worst");
    tooltip(
        "Picks the pixel where the chosen metric is greatest, within the region if there is one. Further clicks pick the "
        "next worst pixel, at least 16 pixels away from the previous ones.",
        "J");
    if (!compare.region) {
        flow(20 * em(), right, em());
        ImGui::TextDisabled("Shift+drag in the picture measures a region.");
        return asked;
    }
    ImGui::SameLine();
    if (ImGui::Button("forget region")) forget_region(compare);
    ui.record_widget_rect("comparison.forget_region");
    tooltip("Measures only the whole picture again.", "Escape");
    if (!compare.region) return asked;
    const PixelRegion region = pixels_of(compare.region, comparison.size());
    flow(16 * em(), right, em());
    ImGui::TextDisabled("region of %d x %d at %d, %d", region.width, region.height, region.x, region.y);
    return asked;
}

}  // namespace

void draw_compare_panel(const Ui& ui, Workspace& w) {
    ExplorerState& state = w.state;
    if (state.ray) {
        ImGui::TextWrapped(
            "A view ray without a scene has no picture to compare. Use the ray editor to go back to the scene.");
        return;
    }
    label("reference");
    ImGui::SetNextItemWidth(-1);
    draw_technique_combo(
        ui, "comparison.reference",
        "The technique that the picture is compared with. It is drawn with the same parameters.", "--compare",
        state.compare.reference);
    if (state.technique == state.compare.reference) {
        ImGui::TextWrapped(
            "The picture is drawn with the reference itself, so there is nothing to compare. Choose another reference "
            "here, or another technique.");
        return;
    }
    draw_modes(ui, state.compare);
    draw_mode_controls(ui, state.compare);
    ImGui::Spacing();
    Comparison& numbers = w.comparison.numbers();
    if (numbers.has_pair()) draw_metrics(ui, numbers, state);
    if (draw_actions(ui, numbers, state.compare)) w.comparison.want_worst();
}

}  // namespace momentscope::ui
