#include "app/chart_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "core/render/view.hpp"
#include "core/report/chart_drawing.hpp"
#include "core/report/chart_html.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "ui/widgets/drawing_painter.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope {

namespace {

constexpr float CHART_SCALE = 1.5f;
constexpr float MAX_SIDE = MAX_PICTURE_SIDE;

void write_chart_picture(const Chart& chart, Metric metric, const std::filesystem::path& path) {
    std::vector<Drawing> drawings;
    glm::vec2 size(0);
    for (const std::span<const ChartRow> rows : scenes_of(chart)) {
        const Drawing& drawing =
            drawings.emplace_back(chart_drawing(rows, metric, setting(chart.settings, "times")));
        size = {std::max(size.x, CHART_SCALE * drawing.size.x), size.y + CHART_SCALE * drawing.size.y};
    }
    if (size.y < 1 || size.y > MAX_SIDE)
        throw Error(fmt::format("A picture of {} scenes cannot be drawn; write a .svg or .html file instead.",
                                drawings.size()));
    const glm::ivec2 pixels(size);
    const auto context = make_headless_context(pixels);
    GuiSession gui(nullptr, CHART_SCALE);
    gui.begin_frame(pixels);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({0, 0}, {size.x, size.y}, IM_COL32_WHITE);
    float top = 0;
    for (const Drawing& drawing : drawings) {
        ui::paint_drawing(list, drawing, {0, top}, CHART_SCALE);
        top += CHART_SCALE * drawing.size.y;
    }
    gui.end_frame(pixels);
    write_png(read_window(pixels), pixels.x, pixels.y, path);
}

}  // namespace

void require_chart_output(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    if (kind != ".csv" && kind != ".md" && kind != ".svg" && kind != ".html" && kind != ".png")
        throw Error(fmt::format("'{}' does not end in .csv, .md, .svg, .html or .png; give -o such a name.",
                                path.string()));
    require_writable(path);
}

void write_chart(const RunTable& table, Metric metric, const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    if (kind == ".csv") return write_file(run_table_text(table), path);
    const Chart chart = chart_of(table, path.string());
    if (kind == ".md") return write_file(chart_to_markdown(chart, metric), path);
    if (kind == ".svg") return write_file(chart_to_svg(chart, metric), path);
    if (kind == ".html") return write_file(chart_to_html(chart, metric), path);
    write_chart_picture(chart, metric, path);
}

}  // namespace momentscope
