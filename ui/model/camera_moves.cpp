#include "ui/model/camera_moves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/camera.hpp"

namespace momentscope::ui {

namespace {

constexpr float STEEPEST = 1.5f;  // just below the poles, where the up direction is undefined
constexpr float QUARTER = 0.5f * std::numbers::pi_v<float>;
constexpr NamedView VIEWS[] = {{"front", "Front", 0, 0},      {"back", "Back", 2 * QUARTER, 0},
                               {"left", "Left", -QUARTER, 0}, {"right", "Right", QUARTER, 0},
                               {"top", "Top", 0, STEEPEST},   {"below", "From below", 0, -STEEPEST}};

}  // namespace

std::span<const NamedView> named_views() {
    return VIEWS;
}

Camera looking_from(Camera camera, const NamedView& view) {
    camera.azimuth = view.azimuth;
    camera.elevation = view.elevation;
    return camera;
}

Camera orbited(Camera camera, glm::vec2 moved) {
    constexpr float RADIANS_PER_PIXEL = 0.008f;
    camera.azimuth = std::remainder(camera.azimuth - RADIANS_PER_PIXEL * moved.x, 4 * QUARTER);
    camera.elevation = std::clamp(camera.elevation + RADIANS_PER_PIXEL * moved.y, -STEEPEST, STEEPEST);
    return camera;
}

Camera panned(Camera camera, glm::vec2 moved, glm::ivec2 picture_size) {
    const glm::mat4 view = view_matrix(camera);
    const glm::vec3 right(view[0][0], view[1][0], view[2][0]);
    const glm::vec3 up(view[0][1], view[1][1], view[2][1]);
    // Scene units per pixel at the target's distance, so that the target follows the mouse.
    const glm::vec2 size = glm::max(picture_size, glm::ivec2(1));
    const float unit = 2 * camera.distance / (projection_matrix(camera, size.x / size.y)[1][1] * size.y);
    constexpr float FAR = 1000;
    const glm::vec3 target = camera.target + unit * (-moved.x * right + moved.y * up);
    camera.target = glm::clamp(target, glm::vec3(-FAR), glm::vec3(FAR));
    return camera;
}

Camera zoomed(Camera camera, float notches) {
    camera.distance = std::clamp(camera.distance * std::pow(0.9f, notches), 0.1f, 500.0f);
    return camera;
}

}  // namespace momentscope::ui
