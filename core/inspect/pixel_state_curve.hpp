// pixel_state_curve.hpp -- techniques without moments on one view ray: what the pixel stores, its colour, and
// what is seen of each fragment.
#pragma once
#include <span>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// What math files know of a fragment. Rays without a depth warp count as 1 to 3 scene units deep.
PixelStateFragment pixel_state_fragment(const ViewRay& ray, const Fragment& fragment);

/// What the pixel stores after all fragments, in submission order, as the last pass reads it; at low
/// resolution the mixture of the ray's low-resolution sources. Needs technique.pixel_state.
PixelState pixel_state(const ViewRay& ray, const Technique& technique, const PixelStateSettings& settings);

/// T at `depths` in [-1, 1], for techniques whose weight depends on opacity, too, that of a fragment of the
/// ray's mean opacity. Needs technique.pixel_state_kernel().has_depths().
std::vector<float> pixel_state_transmittance(const ViewRay& ray, const Technique& technique,
                                             const PixelStateSettings& settings,
                                             std::span<const float> depths);

/// What is seen of each fragment relative to its opacity, in submission order: T at its depth or, where
/// fragments are put over each other, what those submitted later let through.
std::vector<float> own_transmittance(const ViewRay& ray, const Technique& technique,
                                     const PixelStateSettings& settings);

/// The pixel's colour over `background`, linear RGB. Needs technique.pixel_state.
glm::vec3 pixel_state_color(const ViewRay& ray, const Technique& technique,
                            const ResolvedParameters& parameters, const glm::vec3& background);

}  // namespace momentscope
