// held_out.hpp -- views at which the rows of a chart were not measured, to see whether their errors hold
// there.
#pragma once
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/render/renderer.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// Both ends of the camera path, and the camera turned by 20 degrees to each side and lifted and lowered by
/// 10, within what a camera can do.
std::vector<Camera> held_out_cameras(const Camera& camera);
constexpr const char* HELD_OUT_TEXT = "1.75 and 20 degrees to each side and 10 degrees up and down";

/// Errors at these views. Needs a current GL context as long as it lives.
class HeldOutViews {
public:
    /// Pictures of that size; `values` are those of the picture, such as the order of submission. Throws
    /// Error when the scene cannot be drawn.
    HeldOutViews(const Scene& scene, glm::ivec2 size, const ParameterValues& values);

    std::size_t count() const { return cameras_.size(); }

    /// Of one view, against `sorted`; infinite when a pixel of the picture is infinite or NaN. Draws
    /// one or two pictures. Means nothing when it was stopped. Throws Error when the GL fails, and when such
    /// a pixel is in the picture by `sorted`.
    double error(const Configuration& configuration, std::size_t view, Metric metric,
                 const std::stop_token& stop = {});

private:
    glm::ivec2 size_;
    ParameterValues values_;
    std::vector<Camera> cameras_;
    std::vector<std::optional<Image>> references_;
    Renderer renderer_;
};

}  // namespace momentscope
