// random_ray.hpp -- random view rays, the same on every machine for the same seed.
#pragma once
#include <cstdint>
#include <random>

#include "core/ray/view_ray.hpp"

namespace momentscope {

/// Uniform numbers from a Mersenne twister by exact arithmetic, which the standard's distributions do not
/// promise.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

    /// In [least, most).
    float uniform(float least, float most) {
        const float unit = static_cast<float>(engine_() >> 8) * 0x1p-24f;
        return least + (most - least) * unit;
    }

    /// In [least, most].
    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<std::uint32_t>(most - least + 1));
    }

private:
    std::mt19937 engine_;
};

/// `count` fragments, depths uniform in [-1, 1], opacities uniform in [least_opacity, most_opacity): the
/// distribution of the published trials for opacities from .05 to .95.
ViewRay random_ray(RandomNumbers& random, int count, float least_opacity = 0.05f, float most_opacity = 0.95f);

/// `count` fragments at random depths, together about as opaque as a few surfaces, however many they are.
ViewRay thin_ray(RandomNumbers& random, int count);

/// The same in two layers of 1 % of the depth range, where the matrix of moments is nearly singular however
/// many they are.
ViewRay layered_ray(RandomNumbers& random, int count);

/// A fragment without a warp, in a colour that tells it from its neighbours by index.
Fragment plain_fragment(float depth, float opacity, std::size_t index);

}  // namespace momentscope
