// measurement.hpp -- all numbers that the window shows of the picked ray, computed from the state and the
// captured pixel.
#pragma once
#include <optional>
#include <vector>

#include "core/inspect/canonical.hpp"
#include "core/inspect/curve.hpp"
#include "core/inspect/error_breakdown.hpp"
#include "core/inspect/pixel_history.hpp"
#include "core/inspect/sharp_bounds.hpp"
#include "core/inspect/steps.hpp"
#include "core/render/light_view.hpp"
#include "ui/state.hpp"

namespace momentscope::ui {

/// Where the truth lies outside of what beta = 0 and beta = 1 give.
struct BoundViolation {
    std::vector<Range> where;  // depths, ascending
    float worst = 0;           // absorbance by which it leaves
    float worst_depth = 0;
};

/// Where the solver's result is no number, or outside [0, b0] before it is clamped. Only the textbook's can
/// be.
struct SolverFailure {
    std::vector<Range> where;  // depths, ascending
    bool no_number = false;    // at one of them at least
};

/// A pinned pixel and its functions.
struct Pinned {
    glm::ivec2 pixel{0};
    ViewRay ray;
    Curve curve;
};

struct Measurement {
    glm::ivec2 pixel{0};
    glm::ivec2 picture_size{0};
    PixelCapture capture;               // its transmittance is of the second pass when it was last asked for
    Curve curve;                        // as the plot draws it; depths ascend
    std::vector<Curve> compared;        // at the same depths
    std::vector<float> unbiased_exact;  // the same; empty while it is not shown
    SharpBounds sharp;                  // at depths of its own; empty until it is computed beside the window
    std::optional<LightView> light;     // when the capture's ray is the light's
    CanonicalRepresentation canonical;
    Steps steps;                           // at the same query depth
    std::vector<PixelHistoryRow> history;  // front to back
    ErrorBreakdown breakdown;              // on the pixel's colour
    BoundViolation exit;
    SolverFailure failure;
    std::vector<Pinned> pins;
};

/// The ray that a viewpoint has of a receiver; viewpoint is not the eye.
const ViewRay& ray_of(const LightView& light, Viewpoint viewpoint);

/// Where to evaluate a curve so that its drawing misses nothing: evenly within the range, and at and around
/// every fragment's own depth.
std::vector<float> plot_depths(const ViewRay& ray, std::size_t samples, Range range = {-1, 1});

/// The part of [-1, 1] that the plot shows.
Range visible_depths(const ViewRay& ray, const PlotState& plot);

/// The warped depth at which bounds, beta and the canonical representation are drawn.
float query_depth(const Measurement& measurement, const ExplorerState& state);

/// Where a curve's truth leaves the band by more than rounding does.
BoundViolation bound_violation(const Curve& curve);

/// Where the curve's solver fails; evaluates it once more per depth if it is the textbook's.
SolverFailure solver_failure(const Curve& curve);

/// What panels say in place of a ray without fragments.
std::string empty_ray_text(const Measurement& measurement);

/// Do two states have the same curves over one capture?
bool same_curves(const ExplorerState& a, const ExplorerState& b);

/// Recomputes what follows from the captures: curves, band, history, pins' curves.
void measure_curves(Measurement& measurement, const ExplorerState& state);

/// Recomputes why the pixel's colour is wrong; depends on all parameters.
void measure_breakdown(Measurement& measurement, const ExplorerState& state);

/// Recomputes the canonical representation and the steps at the query depth, from the curve's moments.
void measure_query(Measurement& measurement, const ExplorerState& state);

}  // namespace momentscope::ui
