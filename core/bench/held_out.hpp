// held_out.hpp -- measures errors at views that a chart did not use, to see whether its errors hold there.
#pragma once
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/render/renderer.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// The held-out views: both ends of the camera path, and the camera turned by 20 degrees to each side, raised
/// by 10 degrees and lowered by 10 degrees, as far as a camera can.
std::vector<Camera> held_out_cameras(const Camera& camera);
constexpr const char* HELD_OUT_TEXT = "1.75 and 20 degrees to each side and 10 degrees up and down";

/// Measures errors at the held-out views. Needs a current GL context during its whole life.
class HeldOutViews {
public:
    /// Draws pictures of this size. values: parameters of all pictures, such as the order of submission.
    /// Throws Error if the scene cannot be drawn.
    HeldOutViews(const Scene& scene, glm::ivec2 size, const ParameterValues& values);

    std::size_t count() const { return cameras_.size(); }

    /// The error at one view, compared with `sorted`; infinite if a pixel of the picture is infinite or NaN.
    /// Draws one or two pictures. If stopped, the result means nothing. Throws Error if the GL fails, and if
    /// the picture of `sorted` has such a pixel.
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
