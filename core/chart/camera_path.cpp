#include "core/chart/camera_path.hpp"

#include <numbers>

namespace momentscope {

namespace {

// The angle by which a camera turns in one frame at 60 Hz, if it turns once around in twelve seconds.
constexpr float STEP_ANGLE = 0.5f * std::numbers::pi_v<float> / 180.0f;

}  // namespace

std::vector<Camera> camera_path(const Camera& camera) {
    std::vector<Camera> path;
    for (int i = 0; i < PATH_FRAMES; ++i) {
        path.push_back(camera);
        path.back().azimuth +=
            STEP_ANGLE * (static_cast<float>(i) - 0.5f * static_cast<float>(PATH_FRAMES - 1));
    }
    return path;
}

glm::ivec2 path_size(glm::ivec2 size) {
    return glm::max(size / 4, glm::ivec2(1));
}

}  // namespace momentscope
