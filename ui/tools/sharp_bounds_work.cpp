#include "ui/tools/sharp_bounds_work.hpp"

#include <utility>

namespace momentscope::ui {

namespace {

constexpr std::size_t BOUND_SAMPLES = 129;

}  // namespace

std::optional<SharpBounds> SharpBoundsWork::update(const PlotState& plot, const Measurement& measurement,
                                                   long ray, Status& status) {
    std::optional<SharpBounds> shown;
    const Curve& curve = measurement.curve;
    const bool wanted =
        curve.technique != nullptr && curve.technique->has_moments() && plot.shows(Series::sharp);
    const ViewRay& view_ray = measurement.capture.ray;
    const Input input = {ray, curve.technique, curve.parameters.theta, visible_depths(view_ray, plot)};
    if (!wanted || asked_ != input) {
        shown.emplace();
        work_.cancel();
        asked_.reset();
    }
    if (auto result = work_.take(); result && asked_) {
        if (!*result) status.say("The linear program of the sharp bounds found no solution on this ray.");
        shown = std::move(*result).value_or(SharpBounds());
    }
    if (!wanted || asked_ || work_.busy()) return shown;
    asked_ = input;
    const auto work = [view_ray, input, parameters = curve.parameters](const std::stop_token& stop,
                                                                       const auto&) {
        return sharp_bounds(view_ray, *input.technique, parameters,
                            plot_depths(view_ray, BOUND_SAMPLES, input.depths), stop);
    };
    work_.start(work);
    return shown;
}

}  // namespace momentscope::ui
