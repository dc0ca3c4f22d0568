#include "core/report/drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "core/support/markup.hpp"

namespace momentscope {

namespace {

// Widths of letters of DejaVu Sans in ems, rounded up.
float letter_width(unsigned char letter) {
    if ((letter & 0xC0) == 0x80) return 0;  // continues a letter of several bytes
    if (std::string_view("ijl|.,:;'I ").find(static_cast<char>(letter)) != std::string_view::npos)
        return 0.34f;
    if (std::string_view("frt-()[]/").find(static_cast<char>(letter)) != std::string_view::npos) return 0.42f;
    if (std::string_view("mwMWQ@%=+<>").find(static_cast<char>(letter)) != std::string_view::npos)
        return 0.98f;
    return letter >= 'A' && letter <= 'Z' ? 0.76f : 0.64f;
}

std::string points_text(const std::vector<glm::vec2>& points) {
    std::string text;
    for (const glm::vec2& point : points) text += fmt::format("{:.1f},{:.1f} ", point.x, point.y);
    return text;
}

std::string shape_text(const Drawing::Mark& mark) {
    const std::string color = css_color(mark.color);
    if (mark.shape == MarkShape::circle)
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"#fff\"/>",
                           mark.at.x, mark.at.y, mark.radius, color);
    if (mark.shape == MarkShape::ring)
        return fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>",
            mark.at.x, mark.at.y, mark.radius, color);
    return fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#fff\"/>",
                       points_text(mark_outline(mark)), color);
}

}  // namespace

std::vector<glm::vec2> mark_outline(const Drawing::Mark& mark) {
    std::vector<glm::vec2> unit;
    switch (mark.shape) {
        case MarkShape::square:
            unit = {{-0.85f, -0.85f}, {0.85f, -0.85f}, {0.85f, 0.85f}, {-0.85f, 0.85f}};
            break;
        case MarkShape::diamond:
            unit = {{0, -1.2f}, {1.2f, 0}, {0, 1.2f}, {-1.2f, 0}};
            break;
        case MarkShape::triangle_up:
            unit = {{0, -1.15f}, {1.1f, 0.85f}, {-1.1f, 0.85f}};
            break;
        case MarkShape::triangle_down:
            unit = {{0, 1.15f}, {-1.1f, -0.85f}, {1.1f, -0.85f}};
            break;
        case MarkShape::triangle_left:
            unit = {{-1.15f, 0}, {0.85f, -1.1f}, {0.85f, 1.1f}};
            break;
        case MarkShape::triangle_right:
            unit = {{1.15f, 0}, {-0.85f, 1.1f}, {-0.85f, -1.1f}};
            break;
        case MarkShape::bar:
            unit = {{-1.3f, -0.55f}, {1.3f, -0.55f}, {1.3f, 0.55f}, {-1.3f, 0.55f}};
            break;
        case MarkShape::pillar:
            unit = {{-0.55f, -1.3f}, {0.55f, -1.3f}, {0.55f, 1.3f}, {-0.55f, 1.3f}};
            break;
        case MarkShape::cross:
            unit = {{-0.4f, -1.1f}, {0.4f, -1.1f}, {0.4f, -0.4f},  {1.1f, -0.4f},
                    {1.1f, 0.4f},   {0.4f, 0.4f},  {0.4f, 1.1f},   {-0.4f, 1.1f},
                    {-0.4f, 0.4f},  {-1.1f, 0.4f}, {-1.1f, -0.4f}, {-0.4f, -0.4f}};
            break;
        case MarkShape::circle:
        case MarkShape::ring:
            for (int i = 0; i < 24; ++i) {
                const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / 24;
                unit.emplace_back(std::cos(angle), std::sin(angle));
            }
    }
    for (glm::vec2& corner : unit) corner = mark.at + mark.radius * corner;
    return unit;
}

float text_width(std::string_view text, float size) {
    float width = 0;
    for (const char letter : text) width += letter_width(static_cast<unsigned char>(letter));
    return width * size;
}

std::string drawing_to_svg(const Drawing& drawing, const std::vector<std::string>& titles) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"'DejaVu Sans',Verdana,sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        drawing.size.x, drawing.size.y);
    const auto out = std::back_inserter(svg);
    for (const Drawing::Line& line : drawing.lines)
        fmt::format_to(out, "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
                       points_text(line.points), css_color(line.color), line.width,
                       line.dashed ? " stroke-dasharray=\"6 4\"" : "");
    for (const Drawing::Mark& mark : drawing.marks) {
        if (mark.row == Drawing::NO_ROW)
            fmt::format_to(out, "{}\n", shape_text(mark));
        else
            fmt::format_to(out, "<g class=\"point\" data-row=\"{}\"><title>{}</title>{}</g>\n", mark.row,
                           markup_escaped(titles[mark.row]), shape_text(mark));
    }
    for (const Drawing::Text& text : drawing.texts)
        fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
                       text.at.x, text.at.y + 0.36f * text.size, text.size, css_color(text.color),
                       text.bold ? " font-weight=\"bold\"" : "", markup_escaped(text.text));
    return svg + "</svg>\n";
}

}  // namespace momentscope
