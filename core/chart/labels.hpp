// labels.hpp -- names beside the points of a drawing, where there is room for them.
#pragma once
#include <string>
#include <vector>

#include "core/chart/drawing.hpp"

namespace momentscope {

struct Label {
    glm::vec2 at;  // of its point
    std::string text;
    glm::vec3 color;
    bool bold = false;
};

/// Rectangles that nothing may overlap.
struct Box {
    glm::vec2 low, high;
    bool overlaps(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

/// Writes labels beside their points, the first ones first, each where it overlaps no `taken` box and no
/// other label and lies within `bounds`; with a line to its point where that is not next to it. Leaves out
/// those for which there is no such place.
void place_labels(Drawing& drawing, const std::vector<Label>& labels, std::vector<Box> taken,
                  const Box& bounds, float size);

}  // namespace momentscope
