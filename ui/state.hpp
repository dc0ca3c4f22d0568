// state.hpp -- all that the user chose, as one value: sessions save it, undo restores it, everything shown
// follows from it.
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

namespace momentscope::ui {

enum class Quantity { absorbance, transmittance };
enum class DepthAxis { warped, view };

/// What the plot can draw. The legend's entries, in its order.
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
    std::optional<Range> depth;  // visible part of the axis, in [-1, 1] or view depth; nullopt: all
    std::optional<Range> value;  // the same of the vertical axis
    std::optional<float>
        query;  // warped depth of the canonical representation; nullopt: the marked fragment's, or 0
    bool shows(Series series) const { return shown[static_cast<std::size_t>(series)]; }
    friend bool operator==(const PlotState&, const PlotState&) = default;
};

/// Whose ray the plot shows: that of the eye through the picked pixel, or what the light's maps of
/// transparent or of opaque casters have of the surface there.
enum class Viewpoint { eye, transparent_casters, opaque_casters };

/// The tabs below the plot.
enum class Panel { controls, fragments, technique, steps, editor, stress, compare, chart };

constexpr std::array<const char*, 8> PANEL_NAMES = {"Controls",   "Fragments", "Technique", "Steps",
                                                    "Ray editor", "Stress",    "Compare",   "Chart"};

/// A view ray from a file. States share it, since a history holds many of them and a ray may be large; equal
/// if it has the same content.
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

/// From many small pixels to a few with all their digits.
enum class LensZoom { far, near, values, digits };
constexpr std::size_t LENS_ZOOM_COUNT = 4;

enum class ThemeKind { dark, light };

constexpr std::size_t MAX_PINS = 4;

/// How picture and reference are shown. off: the picture alone.
enum class CompareMode { off, wipe, difference, false_color };

/// A rectangle of the picture, as fractions from its upper left corner.
struct PictureRegion {
    glm::vec2 low{0};
    glm::vec2 high{1};
    friend bool operator==(const PictureRegion&, const PictureRegion&) = default;
};

constexpr float MIN_GAIN = 1, MAX_GAIN = 64;
constexpr float MIN_DIVIDER = 0.02f, MAX_DIVIDER = 0.98f;

/// What the picture is compared with, and how.
struct CompareState {
    const Technique* reference = &require_technique("sorted");  // drawn with the same parameters
    CompareMode mode = CompareMode::off;
    Metric metric = Metric::rmse;         // of false colour and the worst pixel
    float gain = 4;                       // of difference and false colour
    float divider = 0.5f;                 // of the wipe, as a fraction of the picture's width
    bool swapped = false;                 // wipe: the reference on the right instead of the left
    std::optional<PictureRegion> region;  // of numbers beside those of the whole picture
    friend bool operator==(const CompareState&, const CompareState&) = default;
};

struct ExplorerState {
    std::string scene = "teapots";  // registry id or path of a mesh file
    SharedRay ray;                  // a ray from a file; then its plot is shown without a scene
    const Technique* technique = &require_technique("power6-32");
    std::vector<const Technique*> compared;  // drawn beside it in the plot
    ParameterValues parameters;
    CompareState compare;
    std::optional<Camera> camera;  // nullopt: the scene's own
    std::optional<glm::vec2>
        picked;  // fraction of the picture from its upper left corner; nullopt: the scene's own
    std::vector<glm::vec2> pins;        // at most MAX_PINS, as fractions
    std::optional<std::size_t> marked;  // index of a fragment of the picked ray
    Viewpoint viewpoint = Viewpoint::eye;
    std::optional<std::size_t>
        receiver;  // of the light: index of a fragment of the eye's ray; nullopt: what is seen
    PlotState plot;
    Panel panel = Panel::controls;
    bool lens = false;
    LensZoom lens_zoom = LensZoom::values;
    bool failures = false;  // overlay of failed and clamped reconstructions
    std::string card;       // id of the open "Try this" card, or ""
    bool answer = false;    // is the card's answer shown?
    ThemeKind theme = ThemeKind::dark;
    float scene_share = 0.54f;  // of the window's width, in [0.2, 0.8]
    float plot_share = 0.54f;   // of the right side's height, in [0.2, 0.8]
    friend bool operator==(const ExplorerState&, const ExplorerState&) = default;
};

/// Is the ray that the plot shows one of the light? Needs a scene with shadows.
bool seen_from_light(const ExplorerState& state);

/// What receives the light is the fragment that was marked, else what is seen of the pixel. The light's
/// viewpoints turn shadows on.
void set_viewpoint(ExplorerState& state, Viewpoint viewpoint);

/// What the plot's curve is of: the picture's technique, or that of the light's map.
Configuration plotted_configuration(const ExplorerState& state);

/// Chooses another scene; what belonged to the last one is forgotten.
void choose_scene(ExplorerState& state, const std::string& id_or_path);

/// Shows the whole ray again.
void fit(PlotState& plot);

/// Shows the comparison in that way, or the picture alone if it is shown so already.
void toggle(CompareState& compare, CompareMode mode);

/// The next levels of the lens, closer for positive steps; stops at the last one.
LensZoom zoomed(LensZoom zoom, int steps);

/// Changes an axis, and fits it, since the old range has another unit.
void set_quantity(PlotState& plot, Quantity quantity);
void set_depth_axis(PlotState& plot, DepthAxis axis);

}  // namespace momentscope::ui
