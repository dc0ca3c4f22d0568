// pixel_state_curve.hpp -- evaluates techniques without moments on one view ray: the state of the pixel, its
// colour, and how much of each fragment is seen.
#pragma once
#include <span>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A fragment in the form that math files take. Rays without a depth warp count as 1 to 3 scene units deep.
PixelStateFragment pixel_state_fragment(const ViewRay& ray, const Fragment& fragment);

/// The state of the pixel after all fragments, in submission order, as the last pass reads it. At low
/// resolution it is the mixture of the low-resolution sources of the ray. The technique must have pixel
/// states.
PixelState pixel_state(const ViewRay& ray, const Technique& technique, const ParameterValues& settings);

/// T at `depths` in [-1, 1]. If the technique takes opacity into account, too, this is the T of a fragment
/// with the mean opacity of the ray. Requires technique.pixel_state_kernel().has_depths().
std::vector<float> pixel_state_transmittance(const ViewRay& ray, const Technique& technique,
                                             const ParameterValues& settings, std::span<const float> depths);

/// How much of each fragment is seen, relative to its opacity, in submission order: T at its depth. If the
/// technique blends fragments over each other, it is the transmittance of all fragments submitted later.
std::vector<float> own_transmittance(const ViewRay& ray, const Technique& technique,
                                     const ParameterValues& settings);

/// The colour of the pixel over `background`, in linear RGB. The technique must have pixel states.
glm::vec3 pixel_state_color(const ViewRay& ray, const Technique& technique,
                            const ResolvedParameters& parameters, const glm::vec3& background);

}  // namespace momentscope
