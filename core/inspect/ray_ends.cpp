#include "core/inspect/ray_ends.hpp"

#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl {
namespace {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/ends.glsl"
#pragma GCC diagnostic pop
}  // namespace
}  // namespace glsl

std::optional<DepthInterval> ray_ends(const MomentVector& stored) {
    const glsl::Ends ends = glsl::make_ends(stored.near_step, stored.far_step);
    if (glsl::ends_unknown(ends)) return std::nullopt;
    return DepthInterval{glsl::near_depth(ends), glsl::far_depth(ends)};
}

RayEnd ray_end(float depth, const MomentVector& stored) {
    const int end = glsl::end_at(depth, glsl::make_ends(stored.near_step, stored.far_step));
    if (end == glsl::AT_BOTH_ENDS) return RayEnd::both;
    if (end == glsl::AT_NEAR_END) return RayEnd::near;
    return end == glsl::AT_FAR_END ? RayEnd::far : RayEnd::none;
}

float scene_depth(float place, const Curve& curve) {
    const auto ends = curve.parameters.in_own_interval() ? ray_ends(curve.moments) : std::nullopt;
    return ends ? ends->near + 0.5f * (place + 1) * (ends->far - ends->near) : place;
}

}  // namespace momentscope
