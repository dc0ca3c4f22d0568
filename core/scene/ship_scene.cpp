// ship_scene.cpp -- a full-rigged ship, transparent from keel to pennant, in particle fog; after Fig. 1 and 5
// of the paper.
//
// The bow points to +x, y = 0 is the water, and one unit is about four metres.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>
#include <utility>

#include "core/scene/billboards.hpp"
#include "core/scene/builtin_scenes.hpp"
#include "core/scene/surfaces.hpp"

namespace momentscope {
namespace {

constexpr float PI = std::numbers::pi_v<float>;
constexpr float BRACED = -0.12f;  // angle in radians by which the yards are turned towards the wind
constexpr int PUFFS = 170;
constexpr int FAR_PUFFS = 50;

/// The parts of the ship by material.
struct Parts {
    Mesh planks, frames, spars, sails, ropes, windows, pennants, fog;
};

struct Mast {
    float x, height;
};
constexpr std::array<Mast, 3> MASTS{{{2.7f, 8.0f}, {-0.2f, 9.2f}, {-3.1f, 7.0f}}};

/// Half the width of the ship at the rail. along: from 0 at the stern to 1 at the bow.
float half_width(float along) {
    const float bow = std::max((along - 0.55f) / 0.45f, 0.0f);
    return 1.2f * (0.74f + 0.26f * glm::smoothstep(0.0f, 0.35f, along)) *
           std::sqrt(1.0f - std::pow(bow, 2.4f) * 0.998f);
}

float rail_height(float along) {
    return 0.95f + 3.0f * (along - 0.48f) * (along - 0.48f) + 0.45f * glm::smoothstep(0.3f, 0.18f, along);
}

float keel_height(float along) {
    const float bow = std::max((along - 0.78f) / 0.22f, 0.0f),
                stern = std::max((0.16f - along) / 0.16f, 0.0f);
    return -0.85f + 1.1f * bow * bow + 0.7f * stern * stern;
}

/// A point on the outside of the hull. around: from 0 at one rail over the keel to 1 at the other rail.
glm::vec3 hull_at(float along, float around) {
    const float angle = (around - 0.5f) * PI;
    const float height =
        1.0f - std::pow(std::max(std::cos(angle), 0.0f), 0.75f);  // from 0 at the keel to 1 at the rail
    const float out = std::pow(std::abs(std::sin(angle)), 0.62f) * (1.0f - 0.14f * height * height);
    const float rake =
        0.9f * std::pow(along, 6.0f) * height - 0.35f * (1.0f - along) * (1.0f - along) * height;
    return {-5.0f + 9.6f * along + rake, glm::mix(keel_height(along), rail_height(along), height),
            std::copysign(half_width(along) * out, angle)};
}

void add_hull(Parts& parts) {
    add_surface(parts.planks, 44, 24, [](float u, float v) { return hull_at(u, v); });
    const glm::vec3 middle = 0.5f * (hull_at(0, 0) + hull_at(0, 0.5f));
    add_surface(parts.planks, 20, 1, [&](float u, float v) { return glm::mix(middle, hull_at(0, u), v); });
    for (const float down : {0.3f, 0.95f}) {  // two decks
        add_surface(parts.planks, 30, 2, [&](float u, float v) {
            const float along = 0.02f + 0.955f * u;
            const glm::vec3 rail = hull_at(along, 1.0f);
            return glm::vec3(rail.x - 0.1f * down, rail.y - down, (2 * v - 1) * 0.94f * half_width(along));
        });
    }
    for (int i = 1; i < 18; ++i) {  // frames within the planks
        const float along = static_cast<float>(i) / 18.0f;
        add_surface(parts.frames, 1, 18, [&](float u, float v) {
            const glm::vec3 at = hull_at(along + 0.009f * (u - 0.5f), v);
            return glm::vec3(at.x, at.y, 0.96f * at.z);
        });
    }
    for (const float around : {0.0f, 1.0f}) {  // rails and wales
        for (const float lower : {0.0f, 0.08f, 0.14f}) {
            const auto at = [&](int i) {
                return hull_at(static_cast<float>(i) / 24.0f, glm::mix(around, 0.5f, lower)) +
                       glm::vec3(0, lower > 0 ? 0.0f : 0.05f, 0);
            };
            for (int i = 0; i < 24; ++i) add_tube(parts.spars, at(i), at(i + 1), 0.04f, 0.04f, 5);
        }
    }
}

// Windows lie slightly outside the planks: along both sides, and across the stern.
void add_windows(Parts& parts) {
    for (const bool starboard : {false, true}) {
        for (int i = 0; i < 11; ++i) {
            const float along = 0.14f + 0.062f * static_cast<float>(i);
            add_surface(parts.windows, 2, 2, [&](float u, float v) {
                const float around = 0.085f + 0.04f * v;
                const glm::vec3 at = hull_at(along + 0.024f * u, starboard ? 1.0f - around : around);
                return glm::vec3(at.x, at.y, 1.02f * at.z);
            });
        }
    }
    for (int row = 0; row < 2; ++row) {
        for (int i = 0; i < 5; ++i) {
            const float z = 0.3f * (static_cast<float>(i) - 2.0f);
            add_surface(parts.windows, 1, 1, [&](float u, float v) {
                const float y = 1.05f + 0.5f * static_cast<float>(row) + 0.34f * v;
                return glm::vec3(-5.36f - 0.1f * (y - 1.0f), y, z + 0.22f * (0.5f - u));
            });
        }
    }
}

/// The direction along a yard, to starboard.
glm::vec3 along_yard() {
    return {std::sin(BRACED), 0.0f, std::cos(BRACED)};
}

glm::vec3 before_the_wind() {
    return {std::cos(BRACED), 0.0f, -std::sin(BRACED)};
}

struct Yard {
    glm::vec3 middle;
    float half_length;
};

std::array<Yard, 4> yards_of(const Mast& mast) {
    std::array<Yard, 4> yards;
    constexpr std::array<float, 4> HEIGHTS{0.27f, 0.53f, 0.76f, 0.93f}, LENGTHS{0.235f, 0.2f, 0.155f, 0.11f};
    for (std::size_t i = 0; i < yards.size(); ++i)
        yards[i] = {glm::vec3(mast.x - 0.25f * HEIGHTS[i] + 0.16f, HEIGHTS[i] * mast.height + 0.5f, 0.0f),
                    LENGTHS[i] * mast.height};
    return yards;
}

/// Adds a square sail between two yards, filled by the wind, with an arched foot.
void add_square_sail(Mesh& sails, const Yard& lower, const Yard& upper) {
    add_surface(sails, 14, 12, [&](float u, float v) {
        const float half = 0.94f * glm::mix(lower.half_length, upper.half_length, v);
        glm::vec3 at = glm::mix(lower.middle, upper.middle, v) + (2 * u - 1) * half * along_yard();
        const float height = upper.middle.y - lower.middle.y;
        const float belly = std::sin(PI * u) * std::sin(PI * (0.12f + 0.88f * v));
        at += 0.3f * height * belly * before_the_wind();
        at.y += height * (0.16f * (1 - v) * std::sin(PI * u) + 0.03f * (1 - v) - 0.02f * v);
        return at;
    });
}

/// Adds a sail with three corners, which bulges to starboard.
void add_staysail(Mesh& sails, const glm::vec3& head, const glm::vec3& tack, const glm::vec3& clew) {
    add_surface(sails, 10, 12, [&](float u, float v) {
        const glm::vec3 foot = glm::mix(tack, clew, u);
        const float belly = 0.32f * std::sin(PI * u) * std::sin(PI * v) * glm::distance(tack, clew);
        return glm::mix(foot, head, 0.985f * v) + glm::vec3(0, 0, -belly);
    });
}

void add_mast(Parts& parts, const Mast& mast) {
    const glm::vec3 foot(mast.x, -0.4f, 0.0f), top(mast.x - 0.25f, mast.height + 0.5f, 0.0f);
    add_tube(parts.spars, foot, top, 0.15f, 0.045f, 10);
    const std::array<Yard, 4> yards = yards_of(mast);
    for (std::size_t i = 0; i < yards.size(); ++i) {
        const glm::vec3 end = yards[i].half_length * along_yard();
        add_tube(parts.spars, yards[i].middle, yards[i].middle + end, 0.06f, 0.025f, 6);
        add_tube(parts.spars, yards[i].middle, yards[i].middle - end, 0.06f, 0.025f, 6);
        if (i + 1 < yards.size()) add_square_sail(parts.sails, yards[i], yards[i + 1]);
        for (const float side : {-1.0f, 1.0f}) {  // lifts to the mast, braces aft to the rail
            const glm::vec3 tip = yards[i].middle + side * end;
            add_tube(parts.ropes, tip, yards[i].middle + glm::vec3(-0.1f, 0.14f * mast.height, 0), 0.01f,
                     0.01f, 4);
            add_tube(parts.ropes, tip, {mast.x - 2.3f, 1.3f, side * 0.95f}, 0.01f, 0.01f, 4);
        }
    }
    add_surface(parts.pennants, 16, 1, [&](float u, float v) {
        const float wave = 0.12f * std::sin(7.0f * u) * u;
        return top +
               glm::vec3(1.3f * u, (0.34f - 0.2f * u) * (v - 0.5f) + wave - 0.1f * u, 0.2f * wave - 0.4f * u);
    });
}

// Adds shrouds from the rails to the tops of the mast, with ratlines across.
void add_shrouds(Mesh& ropes, const Mast& mast) {
    constexpr int SHROUDS = 6, RATLINES = 13;
    for (const float side : {-1.0f, 1.0f}) {
        const auto foot = [&](float i) {
            const float x = mast.x + 0.25f - 0.22f * i;
            return glm::vec3(x, rail_height((x + 5.0f) / 9.6f) - 0.05f,
                             side * half_width((x + 5.0f) / 9.6f) * 0.9f);
        };
        const glm::vec3 top(mast.x - 0.12f, 0.62f * mast.height + 0.5f, side * 0.08f);
        for (int i = 0; i < SHROUDS; ++i) add_tube(ropes, foot(float(i)), top, 0.015f, 0.012f, 4);
        for (int i = 1; i < RATLINES; ++i) {
            const float up = 0.92f * float(i) / float(RATLINES);
            add_tube(ropes, glm::mix(foot(0), top, up), glm::mix(foot(SHROUDS - 1), top, up), 0.009f, 0.009f,
                     4);
        }
    }
}

void add_rigging(Parts& parts) {
    for (const Mast& mast : MASTS) {
        add_mast(parts, mast);
        add_shrouds(parts.ropes, mast);
    }
    const auto at = [](const Mast& mast, float up) {
        return glm::vec3(mast.x - 0.25f * up, up * mast.height + 0.5f, 0.0f);
    };
    const glm::vec3 bow(4.6f, 1.75f, 0.0f), bowsprit(7.3f, 3.0f, 0.0f);
    add_tube(parts.spars, bow - glm::vec3(0.8f, 0.35f, 0), bowsprit, 0.12f, 0.05f, 8);
    for (const float up : {0.5f, 0.72f, 0.97f}) {  // stays, from each mast forward to the next
        add_tube(parts.ropes, at(MASTS[0], up), glm::mix(bow, bowsprit, up), 0.014f, 0.014f, 4);
        add_tube(parts.ropes, at(MASTS[1], up), at(MASTS[0], 0.75f * up - 0.25f), 0.014f, 0.014f, 4);
        add_tube(parts.ropes, at(MASTS[2], up), at(MASTS[1], 0.75f * up - 0.25f), 0.014f, 0.014f, 4);
        add_staysail(parts.sails, at(MASTS[0], 0.86f * up), glm::mix(bow, bowsprit, 1.06f * up - 0.06f),
                     glm::mix(bow, bowsprit, 0.1f) + glm::vec3(-0.8f + 0.9f * up, 1.3f * up - 0.1f, -0.35f));
    }
    add_tube(parts.ropes, bowsprit, {4.9f, 0.1f, 0.0f}, 0.014f, 0.014f, 4);
    const glm::vec3 boom = at(MASTS[2], 0.12f), gaff = at(MASTS[2], 0.48f);  // spanker
    const glm::vec3 boom_end = boom + glm::vec3(-2.7f, 0.15f, 0.5f),
                    gaff_end = gaff + glm::vec3(-1.9f, 1.0f, 0.4f);
    add_tube(parts.spars, boom, boom_end, 0.06f, 0.03f, 6);
    add_tube(parts.spars, gaff, gaff_end, 0.05f, 0.03f, 6);
    add_surface(parts.sails, 12, 10, [&](float u, float v) {
        const glm::vec3 fore = glm::mix(boom, gaff, v), aft = glm::mix(boom_end, gaff_end, v);
        const float belly = 0.4f * std::sin(PI * u) * std::sin(PI * v);
        return glm::mix(fore, aft, 0.03f + 0.95f * u) + glm::vec3(0, 0.1f, belly);
    });
}

Billboard make_puff_at(const glm::vec3& center, float radius, const Camera& camera, RandomNumbers& random) {
    Billboard puff;
    // Not below the water, which would cut it off along a straight line.
    puff.center = glm::vec3(center.x, std::max(center.y, 0.92f * radius), center.z);
    puff.radius = radius;
    puff.facing = towards_camera(camera);
    puff.normal = glm::normalize(glm::vec3(random.uniform(-0.4f, 0.4f), 0.9f, 0.0f) + 0.6f * puff.facing);
    puff.turn = random.uniform(0.0f, 2.0f * PI);
    return puff;
}

// Adds fog low on the water around the ship, some of it in front and more behind, and a bank of fog that
// hides the horizon.
void add_fog(Parts& parts, const Camera& camera) {
    RandomNumbers random(23);
    const glm::vec3 back = -towards_camera(camera);
    for (int i = 0; i < PUFFS; ++i) {
        const glm::vec3 place = in_unit_ball(random);
        const glm::vec3 center(9.5f * place.x, 2.6f * place.y * place.y, 5.5f * place.z);
        const float radius = random.uniform(0.8f, 1.5f) + (center.y > 1.5f ? 0.5f : 0.0f);
        add_billboard(parts.fog, make_puff_at(center + 1.2f * back, radius, camera, random), 8);
    }
    const glm::vec3 aside = glm::normalize(glm::cross(back, glm::vec3(0, 1, 0)));
    for (int i = 0; i < FAR_PUFFS; ++i) {
        const float sideways = random.uniform(-15.0f, 15.0f);
        const glm::vec3 center = random.uniform(7.0f, 13.0f) * back + sideways * aside;
        const float radius = random.uniform(2.2f, 3.8f);
        add_billboard(parts.fog, make_puff_at(glm::vec3(center.x, 1.0f, center.z), radius, camera, random),
                      8);
    }
}

}  // namespace

Scene build_ship() {
    Scene scene;
    scene.id = "ship";
    scene.camera = {glm::vec3(0.8f, 4.85f, 0.0f), 25.0f, 0.66f, 0.05f, 0.44f};
    scene.background = linear_color(0xC7D2DA);
    scene.picked = {0.391f, 0.751f};  // fog, the main mast, planks and frames of both sides
    Parts parts;
    add_hull(parts);
    add_windows(parts);
    add_rigging(parts);
    add_fog(parts, scene.camera);
    const auto add = [&](Mesh& mesh, std::uint32_t color, float opacity) {
        scene.objects.push_back(
            {add_mesh(scene, std::move(mesh)), glm::mat4(1), linear_color(color), opacity});
    };
    // Not in order of depth: parts of every material lie in front of and behind parts of every other.
    add(parts.sails, 0xE6D6B4, 0.55f);
    add(parts.planks, 0x6E4527, 0.6f);
    add(parts.ropes, 0x3B3128, 0.8f);
    add(parts.fog, 0xE9ECEE, 0.27f);
    scene.objects.back().alpha_map = add_alpha_map(scene, make_puff(5));
    add(parts.windows, 0xE8C877, 0.45f);
    add(parts.spars, 0x8A6238, 0.85f);
    add(parts.frames, 0x5A3D28, 0.7f);
    add(parts.pennants, 0xB02A20, 0.85f);
    add_ground(scene, 1500.0f, 0.0f, linear_color(0x587280));
    return scene;
}

}  // namespace momentscope
