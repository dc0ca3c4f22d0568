#include "core/ray/view_ray.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl::fragment {
#include "shaders/shared/portable_math.glsl"
// fragment.glsl needs portable_math.glsl before it.
#include "shaders/shared/fragment.glsl"
#include "shaders/shared/random_bits.glsl"
}  // namespace glsl::fragment

std::uint32_t fragment_seed(std::uint32_t pixel, std::uint32_t object, std::uint32_t depth_bits) {
    return glsl::fragment::fragment_seed(pixel, object, depth_bits);
}

float unit_random(std::uint32_t seed, int i) {
    return glsl::fragment::unit_random(seed, i);
}

float fragment_absorbance(float opacity) {
    return glsl::fragment::absorbance_of_opacity(opacity);
}

float transmittance(float absorbance) {
    return glsl::fragment::transmittance_of(absorbance);
}

namespace {

glsl::fragment::DepthWarpFactors factors_of(const DepthWarp& warp) {
    return warp.kind == DepthWarp::Kind::linear ? glsl::fragment::linear_depth_factors(warp.z_min, warp.z_max)
                                                : glsl::fragment::depth_warp_factors(warp.z_min, warp.z_max);
}

}  // namespace

float to_depth(float view_depth, const DepthWarp& warp) {
    if (!warp.has_view_depths()) return std::clamp(view_depth, -1.0f, 1.0f);
    return glsl::fragment::warped_depth(view_depth, factors_of(warp));
}

float to_view_depth(float depth, const DepthWarp& warp) {
    return warp.has_view_depths() ? glsl::fragment::unwarped_depth(depth, factors_of(warp)) : depth;
}

glm::vec3 depth_warp_factors(const DepthWarp& warp) {
    const auto factors = factors_of(warp);
    return {factors.origin, factors.scale, factors.linear ? 1.0f : 0.0f};
}

std::vector<float> own_depths(const ViewRay& ray) {
    std::vector<float> depths;
    for (const Fragment& fragment : ray.fragments) depths.push_back(fragment.depth);
    return depths;
}

std::string fragment_count_text(std::size_t count) {
    return fmt::format("{} fragment{}", count, count == 1 ? "" : "s");
}

double total_absorbance(const ViewRay& ray) {
    double sum = 0;
    for (const Fragment& fragment : ray.fragments)
        sum += static_cast<double>(fragment_absorbance(fragment.opacity));
    return sum;
}

std::vector<double> true_absorbance(const ViewRay& ray, std::span<const float> depths) {
    const std::vector<std::size_t> order = front_to_back(ray);
    std::vector<float> steps;    // depths of the fragments, in ascending order
    std::vector<double> before;  // absorbance in front of each; then the total
    double sum = 0;
    for (const std::size_t i : order) {
        steps.push_back(ray.fragments[i].depth);
        before.push_back(sum);
        sum += static_cast<double>(fragment_absorbance(ray.fragments[i].opacity));
    }
    before.push_back(sum);
    std::vector<double> result;
    result.reserve(depths.size());
    for (const float depth : depths) {
        const auto in_front =
            std::ranges::lower_bound(steps, depth) - steps.begin();  // z_l < depth, strictly
        result.push_back(before[static_cast<std::size_t>(in_front)]);
    }
    return result;
}

std::vector<std::size_t> front_to_back(const ViewRay& ray) {
    std::vector<std::size_t> order(ray.fragments.size());
    std::iota(order.rbegin(), order.rend(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return std::pair(ray.fragments[i].depth, ray.fragments[i].view_depth);
    });
    return order;
}

}  // namespace momentscope
