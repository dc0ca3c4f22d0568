// random_rays.hpp -- the distribution that accuracy is measured on: 1 to 10 fragments, depths uniform in [-1,
// 1], opacities uniform in [.05, .95] (the distribution of the published trials).
#pragma once
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

}  // namespace momentscope::test
