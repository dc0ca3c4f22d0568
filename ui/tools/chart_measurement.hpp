// chart_measurement.hpp -- measures a chart of one scene, and errors at held-out views, between the frames of
// the window.
#pragma once
#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "core/bench/held_out.hpp"
#include "core/bench/measure.hpp"
#include "core/chart/advice.hpp"
#include "core/scene/scene_content.hpp"

namespace momentscope::ui {

/// Needs the window's GL context while it works. If a function throws Error, the caller must cancel.
class ChartMeasurement {
public:
    /// Starts a new chart and discards the previous one. Throws Error if the scene cannot be drawn.
    void start(const Scene& scene, std::vector<Configuration> configurations, const ChartSettings& settings);

    /// Stops measuring. Finished rows stay.
    void cancel() { bench_.reset(); }

    /// Draws pictures for about this many seconds, but at least one. Throws Error if the GL fails.
    void advance(double seconds);

    bool busy() const { return bench_ != nullptr; }
    std::size_t steps_done() const { return done_; }
    std::size_t steps() const { return all_; }
    double seconds_left() const;

    /// The rows in the order of their configurations, block by block.
    const std::vector<ChartRow>& rows() const { return rows_; }
    const Configuration& configuration(std::size_t row) const { return configurations_[row]; }
    const ChartSettings& settings() const { return settings_; }
    const std::string& scene() const { return scene_.id; }
    std::string content() const { return scene_content(scene_); }

    const HeldOutErrors& held_out(Metric metric) const { return held_out_[static_cast<std::size_t>(metric)]; }

    /// Draws one held-out view of a row whose error at these views is unknown. Throws Error if the GL fails.
    void check(std::size_t row, Metric metric);

private:
    void begin_block();

    Scene scene_;
    ChartSettings settings_;
    std::vector<Configuration> configurations_;
    std::vector<ChartRow> rows_;
    std::unique_ptr<ChartBench> bench_;
    std::size_t done_ = 0, all_ = 0;
    std::chrono::steady_clock::time_point begin_;

    struct Check {
        std::size_t row = 0;
        Metric metric = Metric::rmse;
        std::size_t view = 0;
        double worst = 0;
    };
    std::unique_ptr<HeldOutViews> views_;  // created on first use
    Check check_;
    std::array<HeldOutErrors, METRIC_COUNT> held_out_;
};

}  // namespace momentscope::ui
