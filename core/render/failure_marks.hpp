// failure_marks.hpp -- counts and marks the pixels of a picture whose reconstruction cannot be trusted.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/render/drawn_picture.hpp"

namespace momentscope {

/// How many pixels cannot be trusted (failures.frag). failed, robust solver: pixels whose matrix of moments
/// had a pivot below the floor, or with a NaN. failed, textbook solver: pixels with a NaN, or with a sum
/// outside [0, 1] by more than 1e-4. clamped, robust solver: other pixels with such a sum.
struct FailureCounts {
    long failed = 0, clamped = 0;
    std::vector<glm::ivec2> failed_pixels = {};  // row by row from the upper left
};

class FailureMarks {
public:
    /// size: of the picture. depth: the texture of its opaque depths.
    FailureMarks(glm::ivec2 size, GLuint depth);

    /// nullopt, and nothing is drawn, if the technique reconstructs nothing.
    std::optional<FailureCounts> draw(const DrawnPicture& picture);

    /// sRGB with alpha, to be drawn over the picture.
    GLuint texture() const { return color_; }

private:
    GlTexture counts_, color_;
    GlFramebuffer target_, color_target_;
};

}  // namespace momentscope
