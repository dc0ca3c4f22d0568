// random_rays.hpp -- the distribution of rays for measuring accuracy: 1 to 10 fragments, depths uniform in
// [-1, 1], opacities uniform in [0.05, 0.95] (as in the published trials).
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "tests/property/portable_random.hpp"

namespace momentscope::test {

inline ViewRay random_ray(std::mt19937& random, int most_fragments = 10) {
    ViewRay ray;
    for (int i = uniform_whole(random, 1, most_fragments); i > 0; --i) {
        Fragment fragment;
        fragment.depth = fragment.view_depth = uniform(random, -1.0f, 1.0f);
        fragment.opacity = uniform(random, 0.05f, 0.95f);
        ray.fragments.push_back(fragment);
    }
    return ray;
}

/// Surfaces close to each other, which float moments hardly distinguish: 3 to 10 fragments in 1 to 3 groups,
/// with 1e-4 to 1e-2 between neighbours in a group.
inline ViewRay clustered_ray(std::mt19937& random) {
    // the next depth of each group
    std::vector<float> next(static_cast<std::size_t>(uniform_whole(random, 1, 3)));
    for (float& start : next) start = uniform(random, -1.0f, 1.0f);
    const int fragments = uniform_whole(random, 3, 10);
    ViewRay ray;
    for (int i = 0; i < fragments; ++i) {
        float& at = next[static_cast<std::size_t>(i) % next.size()];
        Fragment fragment;
        fragment.depth = fragment.view_depth = std::min(at, 1.0f);
        fragment.opacity = uniform(random, 0.05f, 0.95f);
        ray.fragments.push_back(fragment);
        at += std::pow(10.0f, uniform(random, -4.0f, -2.0f));
    }
    return ray;
}

}  // namespace momentscope::test
