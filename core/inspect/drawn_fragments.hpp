// drawn_fragments.hpp -- finds the fragments of a ray that a technique draws.
#pragma once
#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// For each fragment of the ray: true if the technique draws it. Only depth peeling leaves fragments out. Of
/// fragments with the same depth in the depth buffer, it draws only the one that was submitted first. If the
/// near and far planes are unknown, warped depths are compared instead.
std::vector<bool> drawn_flags(const ViewRay& ray, const Technique& technique);

/// The ray with only those fragments that the technique draws.
ViewRay drawn_fragments(const ViewRay& ray, const Technique& technique);

/// True if two fragments have the same depth.
bool has_ties(const ViewRay& ray);

}  // namespace momentscope
