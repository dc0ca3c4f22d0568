#include "core/ray/random_ray.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace momentscope {

Fragment plain_fragment(float depth, float opacity, std::size_t index) {
    static constexpr std::array<glm::vec3, 6> COLORS = {
        // Okabe and Ito 2008, in linear RGB. Colour-blind people can tell them apart, too.
        glm::vec3(0.79f, 0.35f, 0.00f), glm::vec3(0.09f, 0.46f, 0.81f), glm::vec3(0.00f, 0.34f, 0.17f),
        glm::vec3(0.87f, 0.77f, 0.05f), glm::vec3(0.00f, 0.17f, 0.45f), glm::vec3(0.66f, 0.11f, 0.00f)};
    const std::uint32_t seed =
        fragment_seed(std::bit_cast<std::uint32_t>(depth), static_cast<std::uint32_t>(index), 0);
    return {.depth = depth,
            .view_depth = depth,
            .opacity = opacity,
            .color = COLORS[index % COLORS.size()],
            .seed = seed,
            .threshold = unit_random(seed, 0)};
}

ViewRay random_ray(RandomNumbers& random, int count, float least_opacity, float most_opacity) {
    ViewRay ray;
    for (int i = 0; i < count; ++i) {
        const float depth = random.uniform(-1, 1);
        const float opacity = random.uniform(least_opacity, most_opacity);
        ray.fragments.push_back(plain_fragment(depth, opacity, static_cast<std::size_t>(i)));
    }
    return ray;
}

ViewRay thin_ray(RandomNumbers& random, int count) {
    const float each = 1 - std::exp(-4.0f / static_cast<float>(count));
    return random_ray(random, count, 0.2f * each, std::min(1.8f * each, 0.99f));
}

ViewRay layered_ray(RandomNumbers& random, int count) {
    ViewRay ray = thin_ray(random, count);
    const float layers[] = {random.uniform(-0.99f, 0.0f), random.uniform(0.0f, 0.99f)};
    for (Fragment& fragment : ray.fragments) {
        const float layer = layers[random.whole(0, 1)];
        fragment.depth = fragment.view_depth = layer + random.uniform(-0.01f, 0.01f);
    }
    return ray;
}

}  // namespace momentscope
