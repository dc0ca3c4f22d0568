#include "core/inspect/sharp_bounds.hpp"

#include <algorithm>

#include "core/inspect/canonical_masses.hpp"
#include "core/inspect/circle_bounds.hpp"
#include "core/inspect/curve.hpp"

namespace momentscope {

namespace {

using reference::Extended;

// The linear program of the circle treats depths that are closer than this as one.
constexpr float MIN_SEPARATION = 1e-5f;

// True if there are so few surfaces that no other distribution has their moments (paper, Section 4.1).
bool determined_on_circle(const ViewRay& ray, int moment_count) {
    std::vector<float> surfaces;
    for (const Fragment& fragment : ray.fragments) {
        const bool is_new = std::ranges::none_of(
            surfaces, [&](float other) { return std::abs(other - fragment.depth) < MIN_SEPARATION; });
        if (fragment.opacity > 0 && is_new) surfaces.push_back(fragment.depth);
        if (surfaces.size() > static_cast<std::size_t>(moment_count)) return false;
    }
    return true;
}

SharpBounds of_truth(const ViewRay& ray, std::span<const float> depths) {
    SharpBounds bounds;
    bounds.depth.assign(depths.begin(), depths.end());
    const std::vector<double> in_front = true_absorbance(ray, depths);
    bounds.lower.assign(in_front.begin(), in_front.end());
    bounds.upper = bounds.lower;
    for (std::size_t i = 0; i < depths.size(); ++i)
        for (const Fragment& fragment : ray.fragments)
            bounds.upper[i] += fragment.depth == depths[i] ? fragment_absorbance(fragment.opacity) : 0;
    return bounds;
}

std::vector<DepthMass> masses_of(const ViewRay& ray, double total) {
    std::vector<DepthMass> masses;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.opacity > 0)
            masses.push_back({static_cast<Extended>(fragment.depth),
                              static_cast<Extended>(fragment_absorbance(fragment.opacity)) /
                                  static_cast<Extended>(total)});
    return masses;
}

std::optional<SharpBounds> on_line(const ViewRay& ray, int degree, std::span<const float> depths,
                                   const std::stop_token& stop) {
    const double total = total_absorbance(ray);
    const auto canonical = CanonicalMasses::of(masses_of(ray, total), degree);
    if (!canonical) return of_truth(ray, depths);
    SharpBounds bounds;
    for (const float depth : depths) {
        if (stop.stop_requested()) return std::nullopt;
        Extended before = 0, until = 0;
        for (const DepthMass& one : canonical->at(static_cast<Extended>(depth))) {
            if (one.depth < static_cast<Extended>(depth)) before += one.mass;
            if (one.depth <= static_cast<Extended>(depth)) until += one.mass;
        }
        const auto absorbance = [&](Extended share) {
            return static_cast<float>(total *
                                      static_cast<double>(std::clamp(share, Extended(0), Extended(1))));
        };
        bounds.depth.push_back(depth);
        bounds.lower.push_back(absorbance(before));
        bounds.upper.push_back(absorbance(until));
    }
    return bounds;
}

}  // namespace

std::optional<SharpBounds> sharp_bounds(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters, std::span<const float> depths,
                                        const std::stop_token& stop) {
    if (!technique.has_moments() || !(total_absorbance(ray) > 0)) return SharpBounds();
    if (!technique.on_circle()) return on_line(ray, technique.moments().moment_count / 2, depths, stop);
    if (determined_on_circle(ray, technique.moments().moment_count)) return of_truth(ray, depths);
    return circle_bounds(ray, technique.moments().moment_count, static_cast<double>(parameters.theta), depths,
                         stop);
}

}  // namespace momentscope
