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

inline std::vector<float> own_depths(const ViewRay& ray) {
    std::vector<float> depths;
    for (const Fragment& fragment : ray.fragments) depths.push_back(fragment.depth);
    return depths;
}

/// How many rays the long measurements use; MOMENTSCOPE_RAYS overrides it.
inline int ray_count(int standard) {
    const char* text = std::getenv("MOMENTSCOPE_RAYS");
    return text != nullptr ? std::max(std::atoi(text), 1) : standard;
}

}  // namespace momentscope::test
