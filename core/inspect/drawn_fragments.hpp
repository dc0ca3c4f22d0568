// drawn_fragments.hpp -- which fragments of a ray a technique draws.
#pragma once
#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Whether the technique draws each fragment of the ray: all are drawn, but depth peeling draws, of those
/// that have one depth in the depth buffer, only the one that is submitted first. Without known near and far
/// planes depths are compared as they are.
std::vector<bool> drawn_flags(const ViewRay& ray, const Technique& technique);

/// The ray with the drawn fragments alone.
ViewRay drawn_fragments(const ViewRay& ray, const Technique& technique);

/// Do two of the fragments have the same depth?
bool has_ties(const ViewRay& ray);

}  // namespace momentscope
