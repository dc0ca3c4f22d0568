// state.hpp -- all choices of the user as one value. Sessions save it, undo restores it, and everything that
// is shown follows from it.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/ray/view_ray.hpp"
#include "core/scene/scene.hpp"
#include "core/techniques/configuration.hpp"
#include "core/techniques/technique.hpp"
#include "ui/model/panel_list.hpp"

namespace momentscope::ui {

enum class Quantity { absorbance, transmittance };
enum class DepthAxis { warped, view };

/// The series of the plot, in the order of the legend.
enum class Series : std::size_t {
    truth,
    reconstruction,
    bounds,
    sharp,
    unbiased_exact,
    stems,
    errors,
    wrapping_zone
};
constexpr std::size_t SERIES_COUNT = 8;

/// An interval of an axis; low < high.
struct Range {
    float low = 0;
    float high = 1;
    friend bool operator==(const Range&, const Range&) = default;
};

struct PlotState {
    Quantity quantity = Quantity::absorbance;
    DepthAxis axis = DepthAxis::warped;
    std::array<bool, SERIES_COUNT> shown = {true, true, true, false, false, true, true, true};
    std::optional<Range> depth;  // visible part of the axis, in warped or view depth; nullopt: all
    std::optional<Range> value;  // visible part of the vertical axis
    // Warped query depth; nullopt: that of the marked fragment, or 0.
    std::optional<float> query;
    bool shows(Series series) const { return shown[static_cast<std::size_t>(series)]; }
    friend bool operator==(const PlotState&, const PlotState&) = default;
};

/// The ray that the plot shows: from the eye through the picked pixel, or from the light to the surface
/// there, in the light's map of transparent or of opaque casters.
enum class Viewpoint { eye, transparent_casters, opaque_casters };

/// A view ray without a scene. States share it, because a history holds many states and a ray may be large.
/// Two are equal if they have the same content.
class SharedRay {
public:
    SharedRay() = default;
    SharedRay(ViewRay ray)
        : ray_(std::make_shared<const ViewRay>(std::move(ray))) {}  // NOLINT: reads as a value
    explicit operator bool() const { return ray_ != nullptr; }
    const ViewRay& operator*() const { return *ray_; }
    const ViewRay* operator->() const { return ray_.get(); }
    void reset() { ray_.reset(); }
    friend bool operator==(const SharedRay& a, const SharedRay& b) {
        return a.ray_ == b.ray_ || (a && b && *a == *b);
    }

private:
    std::shared_ptr<const ViewRay> ray_;
};

/// From many small pixels to a few large ones with all their digits.
enum class LensZoom { far, near, values, digits };
constexpr std::size_t LENS_ZOOM_COUNT = 4;

enum class ThemeKind { dark, light };

constexpr std::size_t MAX_PINS = 4;

/// How picture and reference are shown. off: only the picture. uncertainty: what the moments leave open,
/// without a reference.
enum class CompareMode { off, wipe, difference, false_color, uncertainty };

/// A rectangle in the picture, in fractions from the upper left corner.
struct PictureRegion {
    glm::vec2 low{0};
    glm::vec2 high{1};
    friend bool operator==(const PictureRegion&, const PictureRegion&) = default;
};

constexpr float MIN_GAIN = 1, MAX_GAIN = 64;
constexpr float MIN_DIVIDER = 0.02f, MAX_DIVIDER = 0.98f;

/// The reference of the picture, and how the two are compared.
struct CompareState {
    const Technique* reference = &require_technique("sorted");  // drawn with the same parameters
    CompareMode mode = CompareMode::off;
    Metric metric = Metric::rmse;         // for false colour and the worst pixel
    float gain = 4;                       // for differences and false colours
    float divider = 0.5f;                 // of the wipe, as a fraction of the picture's width
    bool swapped = false;                 // in the wipe, the reference is on the right instead of the left
    std::optional<PictureRegion> region;  // metrics are also computed for this region
    friend bool operator==(const CompareState&, const CompareState&) = default;
};

struct ExplorerState {
    std::string scene = "teapots";  // id in the registry, or path of a mesh file
    SharedRay ray;                  // if set, its plot is shown without a scene
    const Technique* technique = &require_technique("power6-32");
    std::vector<const Technique*> compared;  // drawn in the plot, too
    ParameterValues parameters;
    CompareState compare;
    std::optional<Camera> camera;  // nullopt: the scene's own
    // Fraction of the picture from the upper left corner; nullopt: the scene's own.
    std::optional<glm::vec2> picked;
    std::vector<glm::vec2> pins;        // at most MAX_PINS, as fractions
    std::optional<std::size_t> marked;  // index of a fragment of the picked ray
    Viewpoint viewpoint = Viewpoint::eye;
    // Receiver of the light: index of a fragment of the eye's ray; nullopt: the visible surface.
    std::optional<std::size_t> receiver;
    PlotState plot;
    Panel panel = Panel::controls;
    bool lens = false;
    LensZoom lens_zoom = LensZoom::values;
    bool failures = false;  // overlay of failed and clamped reconstructions
    std::string card;       // id of the open lesson, or ""
    std::size_t step = 0;   // of the lesson
    bool hint = false;      // are the hint and the answer of the step shown?
    bool answer = false;
    ThemeKind theme = ThemeKind::dark;
    float scene_share = 0.54f;  // of the window's width, in [0.2, 0.8]
    float plot_share = 0.54f;   // of the right side's height, in [0.2, 0.8]
    friend bool operator==(const ExplorerState&, const ExplorerState&) = default;
};

/// The configuration of the plotted curve: that of the picture, or that of the light's map.
Configuration plotted_configuration(const ExplorerState& state);

/// Shows the comparison in this mode, or only the picture if this mode is active already.
void toggle(CompareState& compare, CompareMode mode);

/// The level of the lens after some steps, closer for positive ones; stops at the first and the last level.
LensZoom zoomed(LensZoom zoom, int steps);

}  // namespace momentscope::ui
