// pixel_capture.hpp -- a pixel of a picture as the GL computed it.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

/// `transmittance` is parallel to ray.fragments.
struct PixelCapture {
    ViewRay ray;
    std::vector<float> transmittance;    // T from the second pass; empty if the technique computes none
    std::optional<MomentVector> stored;  // moments of the first pass, as shaders read them; nullopt: none
    glm::vec3 behind{0.2f};              // linear RGB of the opaque surface behind; grey without a scene
};

}  // namespace momentscope
