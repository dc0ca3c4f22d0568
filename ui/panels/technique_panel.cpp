#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/panels/panels.hpp"

namespace momentscope::ui {

namespace {

void row(const char* name, const std::string& value, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    tooltip(help);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", value.c_str());
}

std::string memory(const Technique& technique, const ParameterValues& values, glm::ivec2 size) {
    const int stored = stored_bits(technique, values);
    const int bits = bits_with_factor(technique, values);
    if (bits == 0) return bits_text(technique, bits);
    const double bytes = static_cast<double>(bits) / 8 * size.x * size.y;
    const std::string factor = bits == stored ? "" : fmt::format(", {} with the factor", bits);
    return fmt::format("{} bits per pixel{}: {:.1f} MB for these {} × {} pixels", stored, factor, bytes / 1e6,
                       size.x, size.y);
}

// All techniques side by side. A click chooses one.
void draw_comparison(const Ui& ui, ExplorerState& state) {
    constexpr std::array COLUMNS = {"technique", "bits", "with factor", "passes", "order", "bounds"};
    ImGui::Spacing();
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted("All techniques");
    ImGui::PopFont();
    const ImGuiTableFlags flags =
        ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("all techniques", static_cast<int>(COLUMNS.size()), flags)) return;
    for (const char* column : COLUMNS) ImGui::TableSetupColumn(column);
    ImGui::TableHeadersRow();
    const auto cell = [](const std::string& text) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
    };
    const auto bits = [](int count, const Technique& one) {
        return count == 0 && one.is_truth() ? std::string("no limit") : fmt::format("{}", count);
    };
    for (const Technique& one : techniques()) {
        const std::string why_not = why_unavailable(one, ui.gl);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::BeginDisabled(!why_not.empty());
        if (ImGui::Selectable(one.id, state.technique == &one, ImGuiSelectableFlags_SpanAllColumns))
            state.technique = &one;
        ui.record_widget_rect(fmt::format("technique.{}", one.id));
        tooltip(why_not.empty() ? one.description : fmt::format("Not available here. {}", why_not),
                one.source);
        cell(bits(stored_bits(one, state.parameters), one));
        cell(bits(bits_with_factor(one, state.parameters), one));
        cell(one.geometry_passes > 0 ? fmt::format("{}", one.geometry_passes) : "one per layer");
        cell(one.order_dependent ? "matters" : "any");
        cell(one.has_bounds() ? "yes" : "–");
        ImGui::EndDisabled();
    }
    ImGui::EndTable();
}

}  // namespace

void draw_technique_panel(const Ui& ui, Workspace& w) {
    ExplorerState& state = w.state;
    const Technique& technique = *state.technique;
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(technique.name);
    ImGui::PopFont();
    ui.record_widget_rect("technique.name");
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - button_width("which for my scene?"), 0.0f));
    ImGui::BeginDisabled(state.ray || w.chart.busy());
    if (ImGui::Button("which for my scene?")) measure_chart(w);
    ImGui::EndDisabled();
    ui.record_widget_rect("technique.advise");
    tooltip(
        "Measures the time and the error of every technique on this scene, and names the cheapest within limits.",
        "It opens the tab Chart.");
    ImGui::TextWrapped("%s", technique.description);
    ImGui::Spacing();
    if (!ImGui::BeginTable("properties", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 10 * em());
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    row("id", technique.id, "The name of the technique on the command line and in session files.");
    row("memory", memory(technique, state.parameters, w.measurement().picture_size),
        "What the technique stores in addition to the colour buffers that every technique has. With factorisation per pixel, a "
        "factor of the moments takes their place between the passes and may need more memory.");
    row("geometry passes",
        technique.geometry_passes > 0 ? fmt::format("{}", technique.geometry_passes) : "one for every layer",
        "How often the transparent geometry is rasterised.");
    row("order of submission", technique.order_dependent ? "changes the picture" : "does not matter",
        "Whether the order in which geometry is drawn changes the picture.");
    row("bounds", technique.has_bounds() ? "yes: β = 0 and β = 1 are bounds for the biased moments" : "no",
        "Whether the technique can bound how far the truth is from its result.");
    if (technique.has_moments())
        row("recommended bias",
            fmt::format("α = {:.1e}", static_cast<double>(technique.moments().recommended_bias)),
            "What auto means for the moment bias α.");
    row("source", technique.source, "Where it was published.");
    ImGui::EndTable();
    draw_comparison(ui, state);
}

}  // namespace momentscope::ui
