// random_ray.hpp -- random view rays. The same seed gives the same rays on every machine.
#pragma once
#include <cstdint>
#include <random>

#include "core/ray/view_ray.hpp"

namespace momentscope {

/// Uniform random numbers from a Mersenne twister. They are made by exact arithmetic, because the standard
/// does not define the results of its distributions.
/// Draw only one in an expression: compilers evaluate the parts of an expression in different orders, and the
/// numbers would be others.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

    /// A number in [least, most).
    float uniform(float least, float most) {
        const float unit = static_cast<float>(engine_() >> 8) * 0x1p-24f;
        return least + (most - least) * unit;
    }

    /// A point in a box: its z is drawn first, then y, then x.
    glm::vec3 point(const glm::vec3& least, const glm::vec3& most) {
        glm::vec3 point;
        for (int i = 2; i >= 0; --i) point[i] = uniform(least[i], most[i]);
        return point;
    }

    /// A whole number in [least, most].
    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<std::uint32_t>(most - least + 1));
    }

private:
    std::mt19937 engine_;
};

/// `count` fragments with depths uniform in [-1, 1] and opacities uniform in [least_opacity, most_opacity).
/// With opacities from 0.05 to 0.95 this is the distribution of the published trials.
ViewRay random_ray(RandomNumbers& random, int count, float least_opacity = 0.05f, float most_opacity = 0.95f);

/// `count` fragments at random depths. Whatever their number, together they are about as opaque as a few
/// surfaces.
ViewRay thin_ray(RandomNumbers& random, int count);

/// The same, but all fragments lie in two layers, each 1 % of the depth range thick. The matrix of moments is
/// then nearly singular, whatever the number of fragments.
ViewRay layered_ray(RandomNumbers& random, int count);

/// A fragment of a ray without a depth warp. Its colour depends on `index`, so neighbours differ.
Fragment plain_fragment(float depth, float opacity, std::size_t index);

}  // namespace momentscope
