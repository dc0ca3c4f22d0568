// pixel_state_support.hpp -- evaluates techniques without moments on a ray in double precision.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "core/inspect/pixel_state_curve.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope::test {

// Depths in [0, 1] of the depth range, in double.
inline double unit_depth(float depth) {
    return 0.5 * (static_cast<double>(depth) + 1);
}

inline double opacity_of(const Fragment& fragment) {
    return static_cast<double>(fragment.opacity);
}

inline double absorbance_of(const Fragment& fragment) {
    return -std::log1p(-opacity_of(fragment));
}

inline ViewRay colored_ray(RandomNumbers& random, int count) {
    ViewRay ray = random_ray(random, count);
    for (Fragment& fragment : ray.fragments)
        fragment.color = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    return ray;
}

// Composites front to back.
inline glm::dvec4 true_color(const ViewRay& ray) {
    glm::dvec4 result(0, 0, 0, 1);
    for (const std::size_t i : front_to_back(ray)) {
        const Fragment& f = ray.fragments[i];
        result += glm::dvec4(glm::dvec3(f.color) * (result.a * opacity_of(f)), -result.a * opacity_of(f));
    }
    return result;
}

inline glm::dvec4 color_of(const ViewRay& ray, const Technique& technique, const ParameterValues& values) {
    const ParameterValues settings = resolve(values, technique).settings;
    const Composited all =
        technique.pixel_state_kernel().composited(pixel_state(ray, technique, settings), settings);
    return {all.red, all.green, all.blue, all.transmittance};
}

inline void expect_near(const glm::dvec4& a, const glm::dvec4& b, double tolerance) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

// The same ray with other random numbers.
inline ViewRay reseeded(ViewRay ray, std::uint32_t run) {
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        ray.fragments[i].seed = fragment_seed(run, static_cast<std::uint32_t>(i), 77);
        ray.fragments[i].threshold = unit_random(ray.fragments[i].seed, 0);
    }
    return ray;
}

}  // namespace momentscope::test
