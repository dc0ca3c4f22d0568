#include "core/inspect/canonical.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/inspect/ray_ends.hpp"

namespace momentscope {

namespace {

constexpr float PI = std::numbers::pi_v<float>;

}  // namespace

float node_depth(float t, float query, const Curve& curve) {
    const Basis& basis = *curve.technique->moments().basis;
    if (!basis.on_circle()) return scene_depth(query + basis.depth_per_unit() / t, curve);
    const float phase_per_depth = PI - 0.5f * curve.parameters.theta;
    const float phase = (query + 1) * phase_per_depth + 2 * std::atan2(1.0f, t);
    return scene_depth(std::fmod(phase, 2 * PI) / phase_per_depth - 1, curve);
}

float end_of_circle(float wrapping_zone_angle) {
    return 2 * PI / (PI - 0.5f * wrapping_zone_angle) - 1;
}

CanonicalRepresentation canonical_representation(const Curve& curve, float query) {
    CanonicalRepresentation result;
    result.query = query;
    if (curve.technique == nullptr || !curve.technique->has_moments() || !(curve.moments.b0 > 0))
        return result;
    const MomentKernel& kernel = curve.technique->moment_kernel();
    const float b0 = curve.moments.b0;
    const ReconstructionSteps steps = kernel.steps(curve.moments, settings_of(curve.parameters), query);
    result.query_absorbance = steps.query_weight * b0;
    result.in_front = steps.in_front * b0;
    result.floored_pivots = steps.floored_pivots;
    const int roots = kernel.node_count - (steps.with_ends ? 1 : 0);
    for (std::size_t l = 0; l < static_cast<std::size_t>(roots); ++l)
        result.nodes.push_back(
            {node_depth(steps.t[l], steps.depth, curve), steps.weight[l] * b0, steps.value[l]});
    if (steps.with_ends) {
        result.nodes.push_back({scene_depth(-1, curve), steps.near_weight * b0, 1});
        result.nodes.push_back({scene_depth(1, curve), steps.far_weight * b0, 0});
    }
    std::ranges::sort(result.nodes, {}, &PointMass::depth);
    return result;
}

}  // namespace momentscope
