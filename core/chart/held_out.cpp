#include "core/chart/held_out.hpp"

#include <algorithm>
#include <numbers>

#include "core/chart/camera_path.hpp"

namespace momentscope {

namespace {

constexpr float DEGREE = std::numbers::pi_v<float> / 180.0f;
constexpr float TURN = 20 * DEGREE;
constexpr float LIFT = 10 * DEGREE;
constexpr float STEEPEST = 85 * DEGREE;

Camera moved(Camera camera, float azimuth, float elevation) {
    camera.azimuth += azimuth;
    camera.elevation = std::clamp(camera.elevation + elevation, -STEEPEST, STEEPEST);
    return camera;
}

}  // namespace

std::vector<Camera> held_out_cameras(const Camera& camera) {
    const std::vector<Camera> path = camera_path(camera);
    return {path.front(),
            path.back(),
            moved(camera, -TURN, 0),
            moved(camera, TURN, 0),
            moved(camera, 0, LIFT),
            moved(camera, 0, -LIFT)};
}

HeldOutViews::HeldOutViews(const Scene& scene, glm::ivec2 size, const ParameterValues& values)
    : size_(size), values_(values), cameras_(held_out_cameras(scene.camera)), references_(cameras_.size()) {
    renderer_.set_scene(scene);
}

double HeldOutViews::error(const Configuration& configuration, std::size_t view, Metric metric) {
    if (!references_[view]) {
        renderer_.render({cameras_[view], size_, &require_technique("sorted"), values_});
        references_[view] = renderer_.read_picture();
    }
    renderer_.render({cameras_[view], size_, configuration.technique, configuration.values});
    return mean_difference(*references_[view], renderer_.read_picture(), metric);
}

}  // namespace momentscope
