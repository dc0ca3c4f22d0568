#include "ui/tools/chart_measurement.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace momentscope::ui {

namespace {

constexpr std::size_t BLOCK = 6;  // configurations that take turns in a round, as in core/bench/chart_run.cpp

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

void ChartMeasurement::start(const Scene& scene, std::vector<Configuration> configurations,
                             const ChartSettings& settings) {
    views_.reset();
    check_ = {};
    for (HeldOutErrors& errors : held_out_) errors.clear();
    rows_.clear();
    scene_ = scene;
    settings_ = settings;
    configurations_ = std::move(configurations);
    done_ = 0;
    all_ = chart_steps(configurations_.size(), settings_);
    begin_ = Clock::now();
    bench_ = std::make_unique<ChartBench>(scene_, settings_);
    begin_block();
}

void ChartMeasurement::begin_block() {
    const auto left = std::span(configurations_).subspan(rows_.size());
    if (left.empty()) return bench_.reset();
    bench_->begin(left.first(std::min(BLOCK, left.size())));
}

void ChartMeasurement::advance(double seconds) {
    const Clock::time_point begin = Clock::now();
    while (busy()) {
        bench_->advance();
        ++done_;
        if (bench_->finished()) {
            for (ChartRow& row : bench_->rows()) rows_.push_back(std::move(row));
            for (HeldOutErrors& errors : held_out_) errors.resize(rows_.size());
            begin_block();
        }
        if (seconds_since(begin) >= seconds) return;
    }
}

double ChartMeasurement::seconds_left() const {
    return seconds_since(begin_) * static_cast<double>(all_ - done_) /
           static_cast<double>(std::max<std::size_t>(done_, 1));
}

void ChartMeasurement::check(std::size_t row, Metric metric) {
    if (views_ == nullptr) views_ = std::make_unique<HeldOutViews>(scene_, settings_.size, settings_.values);
    if (check_.row != row || check_.metric != metric) check_ = {row, metric, 0, 0};
    check_.worst = std::max(check_.worst, views_->error(configurations_[row], check_.view, metric));
    if (++check_.view < views_->count()) return;
    held_out_[static_cast<std::size_t>(metric)][row] = check_.worst;
    check_ = {};
}

}  // namespace momentscope::ui
