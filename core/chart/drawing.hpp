// drawing.hpp -- a drawing as a value, which painters put on pages and on the screen.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace momentscope {

enum class MarkShape { circle, square, diamond, triangle_up, triangle_down, bar, pillar, cross, ring };

/// Places are in pixels from the upper left; colours are sRGB in [0, 1].
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
        std::size_t row;  // that it stands for, or NO_ROW
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

/// The corners of a shape about a place, or of what a circle and a ring are closest to.
std::vector<glm::vec2> mark_outline(const Drawing::Mark& mark);

/// About how wide a text is in DejaVu Sans, never less than it is.
float text_width(std::string_view text, float size);

/// One <svg> element. Marks of rows are groups of the class `point` with the row in `data-row`, and
/// titles[row] as what a pointer over them tells.
std::string drawing_to_svg(const Drawing& drawing, const std::vector<std::string>& titles);

}  // namespace momentscope
