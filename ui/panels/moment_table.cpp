#include "ui/panels/moment_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/inspect/fragment_moments.hpp"
#include "core/inspect/pixel_color.hpp"
#include "ui/model/selection.hpp"
#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

namespace {

constexpr std::size_t MAX_ROWS = 12;       // further fragments are only counted
constexpr float NUMBER_WIDTH = 3.4f;       // font heights that a number needs
constexpr float FIRST_COLUMNS = 2 * 3.4f;  // of a_l and z_l

/// The places of the columns.
struct Columns {
    float left;    // of the first moment
    float width;   // of a moment
    float row;     // height of a row
    bool numbers;  // is there room for them?
    float scale;   // the number whose bar fills half a column
};

// The number, and below it a bar from the middle of the column, to the right for positive numbers.
void draw_cell(const Ui& ui, ImVec2 corner, const Columns& columns, double value, ImU32 tint) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = corner.x + 0.5f * columns.width;
    const float length =
        std::clamp(static_cast<float>(value) / columns.scale, -1.0f, 1.0f) * (0.5f * columns.width - 2);
    const float top = corner.y + (columns.numbers ? 1.1f * em() : 2);
    const float bottom = corner.y + columns.row - 2;
    list.AddRectFilled({std::min(middle, middle + length), top}, {std::max(middle, middle + length), bottom},
                       tint);
    list.AddLine({middle, top - 1}, {middle, bottom + 1}, ui.colors.axis);
    if (columns.numbers)
        draw_text(list, {middle, corner.y + 0.1f * em()}, {0.5f, 0}, fmt::format("{:.3f}", value),
                  ui.colors.text);
}

// A row: two texts, and a cell for each moment.
void draw_row(const Ui& ui, ImVec2 corner, const Columns& columns, const std::string& first,
              const std::string& second, std::span<const float> values, ImU32 tint) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = corner.y + 0.1f * em();
    draw_text(list, {corner.x + 0.3f * em(), y}, {0, 0}, first, ui.colors.text);
    draw_text(list, {corner.x + NUMBER_WIDTH * em(), y}, {0, 0}, second, ui.colors.text);
    for (std::size_t i = 0; i < values.size(); ++i)
        draw_cell(ui, {columns.left + static_cast<float>(i) * columns.width, corner.y}, columns,
                  static_cast<double>(values[i]), tint);
}

float greatest(const std::vector<MomentVector>& rows, const MomentVector& sum, std::size_t count) {
    float most = std::max(0.1f * sum.b0, 1e-6f);  // small numbers keep small bars
    const auto take = [&](const MomentVector& moments) {
        for (std::size_t i = 0; i < count; ++i) most = std::max(most, std::abs(moments.b[i]));
    };
    for (const MomentVector& row : rows) take(row);
    take(sum);
    return most;
}

void draw_heading(ImVec2 corner, const Columns& columns, std::span<const std::string> names) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = corner.y + 0.5f * columns.row;
    const ImU32 tint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    draw_text(list, {corner.x + 0.3f * em(), y}, {0, 0.5f}, "a_l", tint);
    draw_text(list, {corner.x + NUMBER_WIDTH * em(), y}, {0, 0.5f}, "z_l", tint);
    for (std::size_t i = 0; i < names.size(); ++i)
        draw_text(list, {columns.left + (static_cast<float>(i) + 0.5f) * columns.width, y}, {0.5f, 0.5f},
                  (columns.numbers ? "a_l " : "") + names[i], tint);
}

std::string moments_help(const Measurement& m, std::span<const std::string> names, const MomentVector& sum) {
    std::string text = fmt::format("b₀ = {:.6g}", sum.b0);
    for (std::size_t i = 0; i < names.size(); ++i)
        text +=
            fmt::format("\nΣ a_l {} = {:.6g}, divided by b₀: {:.6g}", names[i], sum.b[i], sum.b[i] / sum.b0);
    if (m.curve.technique->on_circle()) text += "\nφ is the angle of depth on the unit circle.";
    return text;
}

}  // namespace

void draw_moment_table(const Ui& ui, Workspace& w, float width) {
    const Measurement& m = w.measurement();
    if (!m.curve.technique->has_moments() || m.capture.ray.fragments.empty()) return;
    const std::vector<std::string> names = moment_names(*m.curve.technique);
    const std::vector<MomentVector> moments = fragment_moments(m.capture.ray, m.curve);
    const MomentVector sum = ray_moments(m.curve);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const auto count = static_cast<float>(names.size());
    const float cell = std::min((width - FIRST_COLUMNS * em()) / count, 6 * em());
    const Columns columns = {low.x + FIRST_COLUMNS * em(), std::max(cell, 4.0f), 1.6f * em(),
                             cell >= NUMBER_WIDTH * em(), greatest(moments, sum, names.size())};
    const auto row_of = [&](std::size_t index) {
        return ImVec2(low.x, low.y + columns.row * static_cast<float>(index));
    };
    draw_heading(row_of(0), columns, names);
    const std::vector<std::size_t> order = front_to_back(m.capture.ray);
    const std::size_t shown = std::min(order.size(), MAX_ROWS);
    for (std::size_t i = 0; i < shown; ++i) {
        const std::size_t index = order[i];
        const ImVec2 corner = row_of(i + 1);
        ImGui::SetCursorScreenPos(corner);
        ImGui::PushID(static_cast<int>(index));
        if (ImGui::Selectable("##row", w.state.marked == index, 0, {width, columns.row}))
            toggle_mark(w.state, index);
        ImGui::PopID();
        ui.record_widget_rect(fmt::format("moments.{}", i + 1));
        const Fragment& fragment = m.capture.ray.fragments[index];
        draw_row(ui, corner, columns, fmt::format("{:.3f}", fragment_absorbance(fragment.opacity)),
                 fmt::format("{:.3f}", fragment.depth), {moments[index].b.data(), names.size()},
                 ui.colors.bounds);
    }
    std::size_t line = shown + 1;
    if (order.size() > shown)
        draw_row(ui, row_of(line++), columns, fmt::format("… and {} more", order.size() - shown), "", {}, 0);
    ImGui::GetWindowDrawList()->AddLine(row_of(line), {low.x + width, row_of(line).y}, ui.colors.axis);
    draw_row(ui, row_of(line), columns, fmt::format("{:.3f}", sum.b0), "Σ", {sum.b.data(), names.size()},
             ui.colors.reconstruction);
    std::vector<float> normalised(sum.b.begin(), sum.b.begin() + static_cast<std::ptrdiff_t>(names.size()));
    for (float& value : normalised) value /= sum.b0;
    draw_row(ui, row_of(line + 1), columns, "1", "Σ / b₀", normalised, ui.colors.stems);
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({width, columns.row * static_cast<float>(line + 2)});
    ui.record_widget_rect("moments");
    tooltip(moments_help(m, names, sum));
}

void draw_own_ray(const Ui& ui, Workspace& w, const Rect& area) {
    const Measurement& m = w.measurement();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.low, area.high, ui.colors.plot_background);
    const float pad = 0.8f * em();
    ImGui::SetCursorScreenPos({area.low.x + pad, area.low.y + pad});
    ImGui::BeginChild("own ray", {area.high.x - area.low.x - 2 * pad, area.high.y - area.low.y - 2 * pad});
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled(
        "A view ray of its own. The ray editor moves its fragments and goes back to the scene.");
    if (m.capture.ray.fragments.empty()) {
        ImGui::TextWrapped("%s", empty_ray_text(m).c_str());
        return ImGui::EndChild();
    }
    const PixelColors colors =
        pixel_colors(m.capture.ray, m.history, *m.curve.technique, m.curve.parameters, m.capture.behind);
    const auto swatch = [&](const char* name, const glm::vec3& color) {
        ImGui::ColorButton(name, display_color(color),
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoBorder,
                           {0.48f * width, 4 * em()});
        ui.record_widget_rect(fmt::format("own_ray.{}", name));
    };
    swatch("truth", colors.truth);
    ImGui::SameLine(0, 0);
    swatch("technique", colors.technique);
    ImGui::TextUnformatted("the true colour");
    ImGui::SameLine(0.48f * width);
    ImGui::TextUnformatted(fmt::format("by {}, off by {:.4f}", m.curve.technique->id,
                                       glm::length(colors.technique - colors.truth))
                               .c_str());
    ImGui::Spacing();
    if (m.curve.technique->has_moments()) {
        ImGui::PushFont(bold_font());
        ImGui::TextUnformatted("What each fragment adds to the moments");
        ImGui::PopFont();
        draw_moment_table(ui, w, width);
    } else if (!m.curve.technique->is_truth()) {
        ImGui::TextWrapped("%s stores no moments.", m.curve.technique->name);
    }
    ImGui::EndChild();
}

}  // namespace momentscope::ui
