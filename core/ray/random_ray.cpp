#include "core/ray/random_ray.hpp"

#include <array>

namespace momentscope {

Fragment plain_fragment(float depth, float opacity, std::size_t index) {
    static constexpr std::array<glm::vec3, 6> COLORS = {
        // Okabe and Ito 2008, in linear RGB: told apart by the colour-blind too
        glm::vec3(0.79f, 0.35f, 0.00f), glm::vec3(0.09f, 0.46f, 0.81f), glm::vec3(0.00f, 0.34f, 0.17f),
        glm::vec3(0.87f, 0.77f, 0.05f), glm::vec3(0.00f, 0.17f, 0.45f), glm::vec3(0.66f, 0.11f, 0.00f)};
    return {.depth = depth, .view_depth = depth, .opacity = opacity, .color = COLORS[index % COLORS.size()]};
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

}  // namespace momentscope
