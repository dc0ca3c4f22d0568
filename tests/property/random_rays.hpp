// random_rays.hpp -- the distribution of rays for measuring accuracy: 1 to 10 fragments, depths uniform in
// [-1, 1], opacities uniform in [0.05, 0.95] (as in the published trials).
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope::test {

inline ViewRay random_ray(std::mt19937& random, int most_fragments = 10) {
    std::uniform_int_distribution<int> count(1, most_fragments);
    std::uniform_real_distribution<float> depth(-1.0f, 1.0f);
    std::uniform_real_distribution<float> opacity(0.05f, 0.95f);
    ViewRay ray;
    for (int i = count(random); i > 0; --i) {
        Fragment fragment;
        fragment.depth = fragment.view_depth = depth(random);
        fragment.opacity = opacity(random);
        ray.fragments.push_back(fragment);
    }
    return ray;
}

/// Surfaces close to each other, which float moments hardly distinguish: 3 to 10 fragments in 1 to 3 groups,
/// with 1e-4 to 1e-2 between neighbours in a group.
inline ViewRay clustered_ray(std::mt19937& random) {
    std::uniform_int_distribution<int> count(3, 10), groups(1, 3);
    std::uniform_real_distribution<float> depth(-1.0f, 1.0f), opacity(0.05f, 0.95f), exponent(-4.0f, -2.0f);
    std::vector<float> next(static_cast<std::size_t>(groups(random)));  // the next depth of each group
    for (float& start : next) start = depth(random);
    const int fragments = count(random);
    ViewRay ray;
    for (int i = 0; i < fragments; ++i) {
        float& at = next[static_cast<std::size_t>(i) % next.size()];
        Fragment fragment;
        fragment.depth = fragment.view_depth = std::min(at, 1.0f);
        fragment.opacity = opacity(random);
        ray.fragments.push_back(fragment);
        at += std::pow(10.0f, exponent(random));
    }
    return ray;
}

}  // namespace momentscope::test
