#include "ui/widgets/stress_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/report/stress_report.hpp"

namespace momentscope::ui {

namespace {

struct Layout {
    std::size_t columns, rows;
    float row_labels, cell_width, cell_height, heading, group_gap;
};

std::size_t column_count(const std::vector<StressCell>& cells) {
    std::size_t count = 0;
    while (count < cells.size() && cells[count].technique == cells.front().technique) ++count;
    return count;
}

Layout layout_of(const std::vector<StressCell>& cells) {
    const std::size_t columns = column_count(cells);
    return {columns,     columns == 0 ? 0 : cells.size() / columns,
            6 * em(),    2.75f * em(),
            1.6f * em(), 4.6f * em(),
            0.35f * em()};
}

bool begins_group(const std::vector<StressCell>& cells, std::size_t column) {
    return column > 0 && cells[column].condition->group != cells[column - 1].condition->group;
}

// The left edge of each column, and the right edge of the last one.
std::vector<float> column_edges(const std::vector<StressCell>& cells, const Layout& layout) {
    std::vector<float> edges = {layout.row_labels};
    for (std::size_t i = 1; i <= layout.columns; ++i) {
        const bool gap = i < layout.columns && begins_group(cells, i);
        edges.push_back(edges.back() + layout.cell_width + (gap ? layout.group_gap : 0));
    }
    return edges;
}

void centred(ImDrawList* draw, ImVec2 low, float width, float y, ImU32 color, const std::string& text,
             float size) {
    const float taken = ImGui::GetFont()->CalcTextSizeA(size, 1e6f, 0, text.c_str()).x;
    draw->AddText(ImGui::GetFont(), size, {low.x + 0.5f * (width - taken), y}, color, text.c_str());
}

// Draws the name of a group above its columns, in as many lines as the width requires.
void draw_group(ImDrawList* draw, const Ui& ui, const std::string& name, float left, float right, float top) {
    const float size = 0.78f * em();
    const float bottom = top + 3.1f * em();
    const float width = right - left;
    const ImVec2 taken = ImGui::GetFont()->CalcTextSizeA(size, 1e6f, width, name.c_str());
    draw->AddText(ImGui::GetFont(), size, {left, bottom - 0.15f * em() - taken.y}, ui.colors.text,
                  name.c_str(), nullptr, width);
    draw->AddLine({left, bottom}, {right - 0.1f * em(), bottom}, ui.colors.axis);
}

void draw_headings(const Ui& ui, const std::vector<StressCell>& cells, const Layout& layout,
                   const std::vector<float>& edges, ImVec2 origin) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < layout.columns;) {
        std::size_t end = i + 1;
        while (end < layout.columns && !begins_group(cells, end)) ++end;
        draw_group(draw, ui, cells[i].condition->group, origin.x + edges[i],
                   origin.x + edges[end - 1] + layout.cell_width, origin.y);
        i = end;
    }
    for (std::size_t i = 0; i < layout.columns; ++i)
        centred(draw, {origin.x + edges[i], 0}, layout.cell_width, origin.y + 3.3f * em(), ui.colors.text,
                cells[i].condition->name, 0.78f * em());
}

bool draw_cell(const StressCell& cell, ImVec2 low, ImVec2 high) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const glm::vec3 color = failure_color(cell.failure_rate());
    const bool dark = 0.3f * color.r + 0.6f * color.g + 0.1f * color.b < 0.5f;
    draw->AddRectFilled(low, high, packed(color), 2);
    centred(draw, low, high.x - low.x, low.y + 0.35f * em(),
            dark ? IM_COL32_WHITE : IM_COL32(20, 20, 20, 255), rate_text(cell.failure_rate()), 0.78f * em());
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(&cell);
    const bool clicked = ImGui::InvisibleButton("cell", {high.x - low.x, high.y - low.y});
    tooltip(fmt::format("{}, {} {}. {}\n{}", cell.technique->id, cell.condition->group, cell.condition->name,
                        cell.condition->help, cell_sentence(cell)),
            "Click to open the worst ray of this cell in the editor.");
    ImGui::PopID();
    return clicked;
}

}  // namespace

ImVec2 stress_map_size(const std::vector<StressCell>& cells) {
    if (cells.empty()) return {0, 0};
    const Layout layout = layout_of(cells);
    return {column_edges(cells, layout).back(),
            layout.heading + static_cast<float>(layout.rows) * layout.cell_height};
}

std::optional<std::size_t> draw_stress_map(const Ui& ui, const std::vector<StressCell>& cells) {
    if (cells.empty()) return std::nullopt;
    const Layout layout = layout_of(cells);
    const std::vector<float> edges = column_edges(cells, layout);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_headings(ui, cells, layout, edges, origin);
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t row = i / layout.columns;
        const float top = origin.y + layout.heading + static_cast<float>(row) * layout.cell_height;
        if (i % layout.columns == 0)
            ImGui::GetWindowDrawList()->AddText({origin.x, top + 0.2f * em()}, ui.colors.text,
                                                cells[i].technique->id);
        const float left = origin.x + edges[i % layout.columns];
        if (draw_cell(cells[i], {left, top}, {left + layout.cell_width - 2, top + layout.cell_height - 2}))
            clicked = i;
        ui.record_widget_rect(fmt::format("stress.{}.{}", cells[i].technique->id, cells[i].condition->id));
    }
    const ImVec2 size = stress_map_size(cells);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(size);
    return clicked;
}

}  // namespace momentscope::ui
