// drawing.hpp -- a drawing as a value, which is painted on pages and on the screen.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

enum class MarkShape {
    circle,
    square,
    diamond,
    triangle_up,
    triangle_down,
    triangle_left,
    triangle_right,
    bar,
    pillar,
    cross,
    ring
};

/// A drawing. Places are in pixels from the upper left; colours are sRGB in [0, 1].
struct Drawing {
    struct Line {
        std::vector<glm::vec2> points;
        glm::vec3 color;
        float width = 1;
        bool dashed = false;
    };
    struct Mark {
        glm::vec2 at;
        MarkShape shape;
        glm::vec3 color;
        float radius;
        std::size_t row;  // row that it represents, or NO_ROW
    };
    struct Text {
        glm::vec2 at;  // its left end, at half the height of its letters
        std::string text;
        float size;  // of the font
        glm::vec3 color;
        bool bold = false;
    };
    static constexpr std::size_t NO_ROW = static_cast<std::size_t>(-1);

    glm::vec2 size{0};
    std::vector<Line> lines;
    std::vector<Mark> marks;
    std::vector<Text> texts;
};

/// The corners of the shape of a mark. Circles and rings are approximated.
std::vector<glm::vec2> mark_outline(const Drawing::Mark& mark);

/// The approximate width of a text in DejaVu Sans, never less than the true width.
float text_width(std::string_view text, float size);

/// The drawing as an <svg> element. Marks of rows are groups with the class `point` and the row in
/// `data-row`. titles[row] is their tooltip.
std::string drawing_to_svg(const Drawing& drawing, const std::vector<std::string>& titles);

}  // namespace momentscope
