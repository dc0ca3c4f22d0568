#include "core/ray/ray_presets.hpp"

#include <array>
#include <utility>

#include "core/ray/random_ray.hpp"

namespace momentscope {

namespace {

ViewRay ray_of(std::initializer_list<std::pair<float, float>> fragments) {
    ViewRay ray;
    for (const auto& [depth, opacity] : fragments)
        ray.fragments.push_back(plain_fragment(depth, opacity, ray.fragments.size()));
    return ray;
}

// A cloud of thin fragments, densest in its middle, between a few surfaces.
ViewRay cloud_and_surfaces() {
    ViewRay ray = ray_of({{-0.75f, 0.35f}, {0.15f, 0.5f}, {0.8f, 0.6f}});
    RandomNumbers random(2);
    for (int i = 0; i < 40; ++i) {
        const float first = random.uniform(-1, 1);
        const float depth = -0.35f + 0.28f * (first + random.uniform(-1, 1)) * 0.5f;
        Fragment fragment = plain_fragment(depth, 0.04f, 0);
        fragment.color = glm::vec3(0.7f);
        ray.fragments.push_back(fragment);
    }
    return ray;
}

ViewRay random_ten() {
    RandomNumbers random(7);
    return random_ray(random, 10);
}

constexpr std::array<RayPreset, 8> PRESETS = {{
    {"one", "1 surface",
     "One surface: every moment-based technique reconstructs it exactly, except for bias.",
     [] {
         return ray_of({{-0.2f, 0.6f}});
     }},
    {"two", "2 surfaces", "Two surfaces, as many as four moments determine.",
     [] {
         return ray_of({{-0.4f, 0.5f}, {0.4f, 0.7f}});
     }},
    {"three", "3 surfaces", "Three surfaces, as in Figure 3a.",
     [] {
         return ray_of({{-0.6f, 0.5f}, {0.0f, 0.5f}, {0.55f, 0.6f}});
     }},
    {"four", "4 surfaces", "Four surfaces, as in Figure 3b.",
     [] {
         return ray_of({{-0.7f, 0.4f}, {-0.25f, 0.5f}, {0.25f, 0.5f}, {0.7f, 0.6f}});
     }},
    {"cloud", "cloud and surfaces", "A cloud of thin fragments between three surfaces, as in Figure 2.",
     cloud_and_surfaces},
    {"ties", "ties",
     "Two pairs of fragments at the same depth: neither fragment of a pair lies in front of the other.",
     [] {
         return ray_of({{-0.3f, 0.4f}, {-0.3f, 0.5f}, {0.4f, 0.3f}, {0.4f, 0.6f}});
     }},
    {"random", "10 random surfaces", "More surfaces than any variant determines.", random_ten},
    {"empty", "empty", "No fragments: double-click to add some.", [] { return ViewRay(); }},
}};

}  // namespace

std::span<const RayPreset> ray_presets() {
    return PRESETS;
}

}  // namespace momentscope
