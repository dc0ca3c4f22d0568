#include "core/shadow/light_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/scene/camera.hpp"
#include "core/support/error.hpp"
#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl::light {
#include "shaders/shared/light_place.glsl"
}  // namespace glsl::light

namespace {

constexpr float STANDARD_DISTANCE = 4;  // radii
constexpr float MIN_DISTANCE = 1.05f;   // radii; at less, the frustum is wider than 144 degrees

}  // namespace

float standard_light_distance(const Sphere& casters) {
    return STANDARD_DISTANCE * std::max(casters.radius, 1e-3f);  // without casters any frustum is right
}

LightCamera light_camera(const ShadowSettings& settings, const Sphere& casters) {
    const float radius = std::max(casters.radius, 1e-3f);
    const float distance = settings.distance.value_or(standard_light_distance(casters));
    if (!(distance >= MIN_DISTANCE * radius))
        throw Error(fmt::format(
            "The light stands {:.2f} from the centre of what casts shadows, too close to the sphere of radius {:.2f} around it; "
            "give a --light-distance of {:.2f} or more.",
            distance, radius, std::ceil(100 * MIN_DISTANCE * radius + 0.5f) / 100));
    const Light& light = settings.light;
    const glm::vec3 direction = orbit_direction(light.azimuth, light.elevation);
    LightCamera frame;
    frame.position = casters.center + distance * direction;
    const bool overhead = light.elevation > 1.5f;
    frame.view =
        glm::lookAt(frame.position, casters.center, overhead ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0));
    frame.near_plane = distance - radius;
    frame.far_plane = distance + radius;
    // The angle of the cone that touches the sphere, with a margin of a thousandth.
    const float angle = std::asin(std::min(1.001f * radius / distance, 0.999f));
    frame.projection = glm::perspective(2 * angle, 1.0f, 0.999f * frame.near_plane, 1.001f * frame.far_plane);
    frame.warp = {DepthWarp::Kind::linear, frame.near_plane, frame.far_plane};
    return frame;
}

ShadowMapPosition light_place(const LightCamera& frame, int map_size, const glm::vec3& world) {
    const glm::vec4 in_light = frame.view * glm::vec4(world, 1);
    const glm::vec4 clip = frame.projection * in_light;
    if (!(-in_light.z > frame.near_plane)) return {};
    const glm::vec3 depth = depth_warp_factors(frame.warp);
    const auto place =
        glsl::light::light_place_of(in_light, clip, {depth.x, depth.y, static_cast<float>(map_size)});
    return {place.texel, place.depth, place.within};
}

}  // namespace momentscope
