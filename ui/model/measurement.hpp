// measurement.hpp -- all numbers that the window shows for the picked ray, computed from the state and the
// captured pixel.
#pragma once
#include <optional>
#include <vector>

#include "core/inspect/canonical.hpp"
#include "core/inspect/curve.hpp"
#include "core/inspect/error_breakdown.hpp"
#include "core/inspect/pixel_capture.hpp"
#include "core/inspect/pixel_history.hpp"
#include "core/inspect/sharp_bounds.hpp"
#include "core/inspect/steps.hpp"
#include "core/shadow/light_view.hpp"
#include "ui/model/state.hpp"

namespace momentscope::ui {

/// Where the truth lies outside the band between the results for beta = 0 and beta = 1.
struct BoundViolation {
    std::vector<Range> where;  // depths, ascending
    float worst = 0;           // greatest absorbance by which it leaves
    float worst_depth = 0;
};

/// Where the solver's result, before clamping, is not finite or outside [0, b0]. Only the textbook solver can
/// fail so.
struct SolverFailure {
    std::vector<Range> where;  // depths, ascending
    bool no_number = false;    // a result is NaN at least once
};

/// A pinned pixel, its ray and its curve.
struct Pinned {
    glm::ivec2 pixel{0};
    ViewRay ray;
    Curve curve;
};

struct Measurement {
    glm::ivec2 pixel{0};
    glm::ivec2 picture_size{0};
    PixelCapture capture;               // its transmittance belongs to the last captured second pass
    Curve curve;                        // as the plot draws it, with ascending depths
    std::vector<Curve> compared;        // at the same depths
    std::vector<float> unbiased_exact;  // at the same depths; empty if hidden
    SharpBounds sharp;                  // at its own depths; empty until computed in the background
    std::optional<LightView> light;     // set if the capture's ray is the light's
    CanonicalRepresentation canonical;
    Steps steps;                           // at the same query depth
    std::vector<PixelHistoryRow> history;  // front to back
    ErrorBreakdown breakdown;              // of the pixel's colour
    BoundViolation exit;
    SolverFailure failure;
    std::vector<Pinned> pins;
};

/// The ray of a viewpoint; `viewpoint` must not be the eye.
const ViewRay& ray_of(const LightView& light, Viewpoint viewpoint);

/// The depths at which to evaluate a curve so that its drawing misses nothing: evenly within the range, and
/// at and around every fragment's own depth.
std::vector<float> plot_depths(const ViewRay& ray, std::size_t samples, Range range = {-1, 1});

/// The part of [-1, 1] that the plot shows.
Range visible_depths(const ViewRay& ray, const PlotState& plot);

/// The warped depth at which bounds, beta and the canonical representation are drawn.
float query_depth(const Measurement& measurement, const ExplorerState& state);

/// Where the truth of a curve leaves the band by more than rounding explains.
BoundViolation bound_violation(const Curve& curve);

/// Where the curve's solver fails. The textbook solver is evaluated once more at every depth.
SolverFailure solver_failure(const Curve& curve);

/// The text that panels show if the ray has no fragments.
std::string empty_ray_text(const Measurement& measurement);

/// Do two states have the same curves for the same capture?
bool same_curves(const ExplorerState& a, const ExplorerState& b);

/// Recomputes everything that follows from the captures: curves, band, history and the curves of the pins.
void measure_curves(Measurement& measurement, const ExplorerState& state);

/// Recomputes why the pixel's colour is wrong. This depends on all parameters.
void measure_breakdown(Measurement& measurement, const ExplorerState& state);

/// Recomputes the canonical representation and the steps at the query depth, from the curve's moments.
void measure_query(Measurement& measurement, const ExplorerState& state);

}  // namespace momentscope::ui
