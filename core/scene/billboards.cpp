#include "core/scene/billboards.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace momentscope {
namespace {

constexpr int PUFF_SIDE = 64;  // texels
constexpr int LATTICE = 7;     // random values along a side

/// Random values on a lattice, interpolated smoothly.
class SmoothNoise {
public:
    explicit SmoothNoise(RandomNumbers& random) {
        for (float& value : values_) value = random.uniform(0, 1);
    }

    /// The value at x and y in [0, 1].
    float at(float x, float y) const {
        const glm::vec2 place = glm::vec2(x, y) * float(LATTICE - 1);
        const glm::ivec2 cell = glm::min(glm::ivec2(place), glm::ivec2(LATTICE - 2));
        const glm::vec2 within = glm::smoothstep(glm::vec2(0), glm::vec2(1), place - glm::vec2(cell));
        const auto value = [&](int dx, int dy) {
            return values_[static_cast<std::size_t>((cell.y + dy) * LATTICE + cell.x + dx)];
        };
        return glm::mix(glm::mix(value(0, 0), value(1, 0), within.x),
                        glm::mix(value(0, 1), value(1, 1), within.x), within.y);
    }

private:
    std::array<float, static_cast<std::size_t>(LATTICE* LATTICE)> values_{};
};

}  // namespace

void add_billboard(Mesh& mesh, const Billboard& billboard, int corners) {
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), billboard.facing));
    const glm::vec3 up = glm::cross(billboard.facing, right);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < corners; ++i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        const glm::vec2 turned(std::cos(angle + billboard.turn), std::sin(angle + billboard.turn));
        mesh.positions.push_back(billboard.center + billboard.radius * (turned.x * right + turned.y * up));
        mesh.normals.push_back(billboard.normal);
        mesh.texture_coordinates.push_back(0.5f + 0.5f * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(corners); ++i)
        mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
}

glm::vec3 in_unit_ball(RandomNumbers& random) {
    while (true) {
        const glm::vec3 point = random.point(glm::vec3(-1), glm::vec3(1));
        if (glm::length(point) < 1) return point;
    }
}

AlphaMap make_puff(std::uint32_t seed) {
    RandomNumbers random(seed);
    const SmoothNoise noise(random);
    AlphaMap puff{PUFF_SIDE, PUFF_SIDE, {}};
    for (int y = 0; y < PUFF_SIDE; ++y) {
        for (int x = 0; x < PUFF_SIDE; ++x) {
            const glm::vec2 place = (glm::vec2(x, y) + 0.5f) / float(PUFF_SIDE);
            // Reaches 0 within the polygon, because its sides cut off a little of the circle.
            const float rim = std::min(2.2f * glm::distance(place, glm::vec2(0.5f)), 1.0f);
            const float dense = (1.0f - rim * rim) * (1.0f - rim * rim);
            const float opacity = dense * (0.4f + 0.6f * noise.at(place.x, place.y));
            puff.bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * opacity)));
        }
    }
    return puff;
}

}  // namespace momentscope
