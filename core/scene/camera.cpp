#include "core/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace momentscope {

namespace {

constexpr float DESIGN_ASPECT = 16.0f / 9.0f;  // the aspect for which scenes choose their cameras

float narrowing(float aspect) {
    return std::max(DESIGN_ASPECT / aspect, 1.0f);
}

}  // namespace

glm::vec3 orbit_direction(float azimuth, float elevation) {
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

glm::mat4 view_matrix(const Camera& camera) {
    const glm::vec3 direction = orbit_direction(camera.azimuth, camera.elevation);
    return glm::lookAt(camera.target + camera.distance * direction, camera.target, glm::vec3(0, 1, 0));
}

glm::mat4 projection_matrix(const Camera& camera, float aspect) {
    const float field_of_view = 2.0f * std::atan(std::tan(0.5f * camera.field_of_view) * narrowing(aspect));
    return glm::perspective(field_of_view, aspect, NEAR_PLANE, FAR_PLANE);
}

glm::ivec2 picked_pixel(const Scene& scene, glm::ivec2 size) {
    const glm::vec2 extent(size);
    const float aspect = extent.x / extent.y;
    const glm::vec2 from_center = scene.picked - 0.5f;
    const glm::vec2 squeeze(std::min(DESIGN_ASPECT / aspect, 1.0f), 1.0f / narrowing(aspect));
    const glm::vec2 pixel = glm::floor((0.5f + from_center * squeeze) * extent);
    return glm::clamp(glm::ivec2(pixel), glm::ivec2(0), size - 1);
}

DepthWarp depth_warp(const Camera& camera, const Sphere& bounds) {
    const float center = -(view_matrix(camera) * glm::vec4(bounds.center, 1)).z;
    const float z_min = std::max(center - bounds.radius, NEAR_PLANE);
    // A range without extent would lead to a division by zero. A thousandth of the depth is far below what
    // can be seen.
    const float z_max = std::max(center + bounds.radius, z_min * 1.001f);
    return {DepthWarp::Kind::logarithmic, z_min, z_max};
}

}  // namespace momentscope
