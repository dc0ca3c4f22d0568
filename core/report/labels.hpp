// labels.hpp -- writes names beside the points of a drawing, where there is room for them.
#pragma once
#include <string>
#include <vector>

#include "core/report/drawing.hpp"

namespace momentscope {

struct Label {
    glm::vec2 at;  // the point that it names
    std::string text;
    glm::vec3 color;
    bool bold = false;
};

/// A rectangle that labels must not overlap.
struct Box {
    glm::vec2 low, high;
    bool overlaps(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

/// Writes labels beside their points, in order of importance. A label must not overlap a `taken` box or
/// another label, and must lie within `bounds`. If it is not next to its point, a line connects them. A label
/// without such a place is left out.
void place_labels(Drawing& drawing, const std::vector<Label>& labels, std::vector<Box> taken,
                  const Box& bounds, float size);

}  // namespace momentscope
