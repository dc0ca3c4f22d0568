// explorer_sharp_bounds.cpp -- the sharp bounds of the plot. They take many linear programs, so a background
// thread computes them.
#include "ui/explorer.hpp"

namespace momentscope::ui {

namespace {

constexpr std::size_t BOUND_SAMPLES = 129;

}  // namespace

// Called once per frame. Bounds for another ray, function or part of the axis are not shown.
void Explorer::update_sharp_bounds() {
    const Curve& curve = measurement_.curve;
    const bool wanted =
        curve.technique != nullptr && curve.technique->has_moments() && state_.plot.shows(Series::sharp);
    const ViewRay& ray = measurement_.capture.ray;
    const SharpBoundsInput input = {curve.technique, curve.parameters.theta,
                                    visible_depths(ray, state_.plot)};
    if (!wanted || sharp_input_ != input) {
        measurement_.sharp = {};
        sharp_bounds_.cancel();
        sharp_input_.reset();
    }
    if (auto result = sharp_bounds_.take(); result && sharp_input_) {
        if (!*result) message_ = "The linear program of the sharp bounds found no solution on this ray.";
        measurement_.sharp = std::move(*result).value_or(SharpBounds());
    }
    if (!wanted || sharp_input_ || sharp_bounds_.busy()) return;
    sharp_input_ = input;
    const auto work = [ray, input, parameters = curve.parameters](std::stop_token stop, const auto&) {
        return sharp_bounds(ray, *input.technique, parameters, plot_depths(ray, BOUND_SAMPLES, input.depths),
                            stop);
    };
    sharp_bounds_.start(work);
}

}  // namespace momentscope::ui
