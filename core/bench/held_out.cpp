#include "core/bench/held_out.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/chart/camera_path.hpp"
#include "core/image/finite_pixels.hpp"
#include "core/support/error.hpp"

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

double HeldOutViews::error(const Configuration& configuration, std::size_t view, Metric metric,
                           const std::stop_token& stop) {
    if (!references_[view]) {
        renderer_.render({cameras_[view], size_, &require_technique("sorted"), values_});
        references_[view] = renderer_.read_picture();
        const std::string why =
            non_finite_text(*references_[view], "the picture by sorted at a held-out view");
        if (!why.empty()) throw Error(why + "; choose a scene with finite colours.");
    }
    if (stop.stop_requested()) return 0;
    renderer_.render({cameras_[view], size_, configuration.technique, configuration.values});
    const Image picture = renderer_.read_picture();
    // Metrics that clamp colours would not notice this.
    if (!non_finite_text(picture, "").empty()) return std::numeric_limits<double>::infinity();
    return mean_difference(*references_[view], picture, metric, stop);
}

}  // namespace momentscope
