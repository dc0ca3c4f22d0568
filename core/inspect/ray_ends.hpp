// ray_ends.hpp -- the ends of a ray and the interval of its moments in C++ (shaders/shared/ends.glsl).
#pragma once
#include <optional>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// An interval of warped depths in [-1, 1].
struct DepthInterval {
    float near = -1, far = 1;
};

/// The ends that a pixel stores; nullopt if they are not known.
std::optional<DepthInterval> ray_ends(const MomentVector& stored);

/// The depth in the scene of a place in the interval that the moments of a curve are taken in.
float scene_depth(float place, const Curve& curve);

/// The end of a ray whose step holds a fragment.
enum class RayEnd { none, near, far, both };

/// The end of a fragment at this depth, from what its pixel stores.
RayEnd ray_end(float depth, const MomentVector& stored);

}  // namespace momentscope
