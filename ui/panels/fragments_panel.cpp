#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/stress/classify.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/moment_table.hpp"
#include "ui/panels/panels.hpp"

namespace momentscope::ui {

namespace {

struct Column {
    const char* name;
    const char* help;
};
constexpr Column COLUMNS[] = {
    {"#", "Position from front to back, and after the slash the position in the order of submission."},
    {"z", "Warped depth in [−1, 1]."},
    {"α_l", "Opacity α_l of the fragment."},
    {"absorb.", "Absorbance −ln(1 − α_l), as the shaders compute it."},
    {"T true", "Transmittance of everything strictly in front of the fragment."},
    {"low, high",
     "The least and the greatest transmittance that the moments, the fragment's own absorbance and the ends of "
     "the ray allow."},
    {"T GL", "Transmittance that the second pass on the GL computed for the fragment."},
    {"T C++", "The same transmittance from the same source, compiled as C++."},
    {"error", "T C++ minus T true: positive if the fragment is too visible."},
    {"weight", "T α_l, the factor of the fragment's colour."},
    {"adds", "Colour that blending adds (source); the tooltip of a row has the numbers."},
    {"onto", "Sum that blending adds to (destination), from the fragments submitted before."}};

std::string submitted_place(const PixelHistoryRow& row) {
    return fmt::format("{}", row.fragment + 1);
}

void swatch(const glm::vec3& linear) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, low.y + 2}, {low.x + 1.5f * em(), low.y + height - 1},
                       ImGui::ColorConvertFloat4ToU32(display_color(linear)), 2);
    list.AddRect({low.x, low.y + 2}, {low.x + 1.5f * em(), low.y + height - 1},
                 ImGui::GetColorU32(ImGuiCol_Border), 2);
    ImGui::Dummy({1.5f * em(), height});
}

std::string vector_text(const glm::vec4& v) {
    return fmt::format("({:.4f}, {:.4f}, {:.4f}; {:.4f})", v.r, v.g, v.b, v.a);
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void draw_row(const Ui& ui, const Measurement& m, const PixelHistoryRow& row, std::size_t place,
              ExplorerState& state) {
    const Fragment& f = m.capture.ray.fragments[row.fragment];
    const bool marked = state.marked == row.fragment;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("{}/{}##{}", place + 1, submitted_place(row), row.fragment);
    if (ImGui::Selectable(label.c_str(), marked, ImGuiSelectableFlags_SpanAllColumns))
        toggle_mark(state, row.fragment);
    ui.record_widget_rect(fmt::format("fragment.{}", place + 1));
    tooltip(fmt::format("View depth {:.4f}; draw call {}, triangle {}. Blending (ONE, ONE) adds {} to {}; in "
                        "linear RGB, with the weight last.",
                        f.view_depth, f.draw, f.primitive, vector_text(row.source), vector_text(row.sum)),
            "click to mark it in the plot");
    cell(fmt::format("{:.3f}", f.depth));
    cell(fmt::format("{:.3f}", f.opacity));
    cell(fmt::format("{:.3f}", row.absorbance + 0.0f));  // it is -0 for opacity 0
    cell(fmt::format("{:.4f}", row.true_transmittance));
    cell(row.estimate
             ? fmt::format("{:.2f} {:.2f}", std::exp(-row.estimate->upper), std::exp(-row.estimate->lower))
             : "–");
    cell(row.gl_transmittance ? fmt::format("{:.4f}", *row.gl_transmittance) : "–");
    cell(fmt::format("{:.4f}", row.transmittance));
    ImGui::TableNextColumn();
    const bool large = std::abs(row.error()) > FAILED_ERROR;
    if (large) ImGui::PushStyleColor(ImGuiCol_Text, ui.colors.warning);
    ImGui::Text("%+.4f%s", row.error(), large ? " !" : "");
    if (large) ImGui::PopStyleColor();
    cell(fmt::format("{:.4f}", row.source.a));
    ImGui::TableNextColumn();
    swatch(glm::vec3(row.source));
    ImGui::TableNextColumn();
    swatch(glm::vec3(row.sum));
}

// Scrolls to the marked row if the mark has moved. The row itself cannot do that, because the clipper skips
// rows outside the view.
void show_marked(const Measurement& m, const ExplorerState& state) {
    const int marked = state.marked ? static_cast<int>(*state.marked) : -1;
    int& last = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("marked"), -1);
    if (std::exchange(last, marked) == marked) return;
    const auto row = std::ranges::find(m.history, state.marked,
                                       [](const PixelHistoryRow& r) { return std::optional(r.fragment); });
    if (row == m.history.end()) return;
    const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const float y = height * static_cast<float>(row - m.history.begin());
    const float view = ImGui::GetWindowHeight() - 4 * height;  // between the header and the scroll bar
    if (y < ImGui::GetScrollY() || y > ImGui::GetScrollY() + view)
        ImGui::SetScrollY(std::max(y - 0.5f * view, 0.0f));
}

std::string summary(const Measurement& m) {
    double worst = 0;
    double squares = 0;
    for (const PixelHistoryRow& row : m.history) {
        worst = std::max(worst, std::abs(row.error()));
        squares += row.error() * row.error();
    }
    return fmt::format("{}, greatest error of T {:.4f}, root mean square {:.4f}",
                       fragment_count_text(m.history.size()), worst,
                       std::sqrt(squares / static_cast<double>(std::max<std::size_t>(m.history.size(), 1))));
}

std::string breakdown_help(const ErrorBreakdown& breakdown) {
    std::string text =
        "The parts of the pixel's error, step by step from the truth to the shown colour. Negative shares "
        "compensate others. Distances are in linear RGB.";
    for (const Contribution& one : breakdown.contributions)
        text += fmt::format("\n{:+.4f}  {}", one.share, one.cause);
    return text;
}

std::string light_help(const LightView& light) {
    const LightBreakdown& v = light.breakdown;
    std::string text = fmt::format(
        "Shares of the light. Transparent casters let {:.4f} through (truth, by a deep shadow map with the same filter: "
        "{:.4f}), opaque ones {:.4f} (truth, by comparing every texel: {:.4f}). The GL shades with {:.4f}.\n"
        "The parts of the difference:",
        v.transmittance, v.true_transmittance, 1 - v.shadowed, 1 - v.true_shadowed, light.visibility);
    for (const Contribution& one : v.contributions)
        text += fmt::format("\n{:+.4f}  {}", one.share, one.cause);
    return text;
}

std::string light_summary(const LightView& light) {
    return fmt::format(
        "Seen from the light: {} of {} filtered texels, with absorbances multiplied by the weight of their texel.",
        fragment_count_text(light.ray.fragments.size()), light.bundle.texels.size());
}

// True if the moments of the fragments are wanted in place of their history.
bool draw_moments_switch(const Ui& ui, Workspace& w) {
    if (!w.measurement().curve.technique->has_moments()) return false;
    const float width = button_width("moments");
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width, 0.0f));
    if (toggle_button("moments", w.fragment_moments)) w.fragment_moments = !w.fragment_moments;
    ui.record_widget_rect("fragments.moments");
    tooltip("Shows what each fragment adds to the moments, instead of its history.");
    return w.fragment_moments;
}

}  // namespace

void draw_fragments_panel(const Ui& ui, Workspace& w) {
    const Measurement& m = w.measurement();
    ExplorerState& state = w.state;
    if (m.history.empty()) {
        ImGui::TextWrapped("%s", empty_ray_text(m).c_str());
        ui.record_widget_rect("fragments.empty");
        return;
    }
    if (m.light) {
        ImGui::TextWrapped("%s", m.light->breakdown.sentence.c_str());
        ui.record_widget_rect("fragments.verdict");
        tooltip(light_help(*m.light));
        ImGui::TextWrapped("%s", light_summary(*m.light).c_str());
    } else {
        const bool hidden = is_hidden(w, VERDICT);
        ImGui::TextWrapped("%s", hidden ? "The lesson hides the verdict until you have answered."
                                        : m.breakdown.sentence.c_str());
        ui.record_widget_rect("fragments.verdict");
        if (!hidden) tooltip(breakdown_help(m.breakdown));
        ImGui::TextUnformatted(summary(m).c_str());
        if (draw_moments_switch(ui, w)) return draw_moment_table(ui, w, ImGui::GetContentRegionAvail().x);
    }
    const ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                  ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit |
                                  ImGuiTableFlags_NoSavedSettings;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {0.2f * em(), 0.1f * em()});  // so that all columns fit a window of 1280 pixels
    if (!ImGui::BeginTable("fragments", static_cast<int>(std::size(COLUMNS)), flags))
        return ImGui::PopStyleVar();
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : COLUMNS) ImGui::TableSetupColumn(column.name);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const Column& column : COLUMNS) {
        ImGui::TableNextColumn();
        ImGui::TableHeader(column.name);
        tooltip(column.help);
    }
    show_marked(m, state);
    ImGuiListClipper clipper;  // a ray from a file may have 100,000 fragments
    clipper.Begin(static_cast<int>(m.history.size()));
    while (clipper.Step())
        for (auto i = static_cast<std::size_t>(clipper.DisplayStart);
             i < static_cast<std::size_t>(clipper.DisplayEnd); ++i)
            draw_row(ui, m, m.history[i], i, state);
    ImGui::EndTable();
    ImGui::PopStyleVar();
}

}  // namespace momentscope::ui
