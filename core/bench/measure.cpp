#include "core/bench/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/chart/camera_path.hpp"
#include "core/compare/difference.hpp"
#include "core/image/finite_pixels.hpp"

namespace momentscope {

/// A configuration that is being measured. It has its own renderer, so no round links programs.
struct ChartBench::Candidate {
    Configuration configuration;
    std::unique_ptr<Renderer> renderer;  // null if this GL cannot draw it
    std::string unavailable;
    ChartNumbers numbers;
    std::vector<double> moments, color, composite, total, differential;  // one value per round

    /// Discards its numbers and its renderer, and says why.
    void refuse(const std::string& why) {
        unavailable = why + "; so it has no error.";
        renderer.reset();
    }

    ChartRow row(const std::string& scene) const {
        ChartRow result = {scene, configuration_text(configuration), unavailable, {}};
        if (renderer != nullptr) result.numbers = numbers;
        return result;
    }
};

namespace {

double sum_of(const PassTimes& times) {
    return times.moments + times.color + times.composite;
}

Configuration reference_configuration(const ParameterValues& values) {
    return {&require_technique("sorted"), values};
}

std::optional<int> unless_zero(int count, bool zero_means_it_grows) {
    return count == 0 && zero_means_it_grows ? std::nullopt : std::optional(count);
}

}  // namespace

std::size_t chart_steps(std::size_t configurations, const ChartSettings& settings) {
    return configurations * (2 + static_cast<std::size_t>(settings.repeat));  // errors, rounds, path
}

ChartBench::~ChartBench() = default;

ChartBench::ChartBench(Scene scene, const ChartSettings& settings)
    : scene_(std::move(scene)), settings_(settings) {
    const Configuration unsorted = {&require_technique("unsorted"), settings_.values};
    baseline_renderer_ = new_renderer();
    baseline_renderer_->render(view_of(unsorted));
}

View ChartBench::view_of(const Configuration& configuration) const {
    return {scene_.camera, settings_.size, configuration.technique, configuration.values};
}

std::unique_ptr<Renderer> ChartBench::new_renderer() const {
    auto renderer = std::make_unique<Renderer>(programs_);
    renderer->set_scene(scene_);
    return renderer;
}

void ChartBench::draw_references(const std::stop_token& stop) {
    if (!path_references_.empty()) return;
    const auto renderer = new_renderer();
    View view = view_of(reference_configuration(settings_.values));
    renderer->render(view);
    reference_ = renderer->read_picture();
    no_reference_ = non_finite_text(reference_, "the picture by sorted");
    view.size = path_size(settings_.size);
    for (const Camera& camera : camera_path(scene_.camera)) {
        if (stop.stop_requested()) return;
        view.camera = camera;
        renderer->render(view);
        path_references_.push_back(renderer->read_picture());
        if (no_reference_.empty())
            no_reference_ =
                non_finite_text(path_references_.back(), "a picture by sorted on the camera path");
    }
}

void ChartBench::compare(Candidate& candidate, const std::stop_token& stop) const {
    candidate.renderer->render(view_of(candidate.configuration));
    const Image picture = candidate.renderer->read_picture();
    if (const std::string why = non_finite_text(picture, "its picture"); !why.empty())
        return candidate.refuse(why);
    ChartNumbers& numbers = candidate.numbers;
    numbers.rmse = mean_difference(reference_, picture, Metric::rmse, stop);
    numbers.delta_e = mean_difference(reference_, picture, Metric::delta_e, stop);
    numbers.flip = mean_difference(reference_, picture, Metric::flip, stop);
    if (!std::isfinite(numbers.rmse))
        return candidate.refuse("The colours of its picture are so great that their squares are infinite");
    const Configuration& configuration = candidate.configuration;
    const Technique& technique = *configuration.technique;
    numbers.stored_bits = unless_zero(stored_bits(technique, configuration.values), technique.is_truth());
    numbers.bits_with_factor =
        unless_zero(bits_with_factor(technique, configuration.values), technique.is_truth());
    numbers.geometry_passes = unless_zero(geometry_passes(configuration), true);
}

void ChartBench::prepare(Candidate& candidate, const std::stop_token& stop) {
    draw_references(stop);
    if (stop.stop_requested()) return;
    if (!no_reference_.empty()) return candidate.refuse(no_reference_);
    candidate.unavailable = why_unavailable(candidate.configuration, baseline_renderer_->gl());
    if (!candidate.unavailable.empty()) return;
    candidate.renderer = new_renderer();
    compare(candidate, stop);  // this also compiles its shaders
}

void ChartBench::time(std::size_t place) {
    if (place == 0) {
        baseline_renderer_->redraw();
        unsorted_ = sum_of(baseline_renderer_->pass_times());
    }
    Candidate& candidate = candidates_[place];
    if (candidate.renderer == nullptr) return;
    candidate.renderer->redraw();
    const PassTimes& times = candidate.renderer->pass_times();
    candidate.moments.push_back(times.moments);
    candidate.color.push_back(times.color);
    candidate.composite.push_back(times.composite);
    candidate.total.push_back(sum_of(times));
    candidate.differential.push_back(sum_of(times) - unsorted_);
}

void ChartBench::follow_path(Candidate& candidate, const std::stop_token& stop) const {
    View view = view_of(candidate.configuration);
    view.size = path_size(settings_.size);
    std::optional<double> before;
    const std::vector<Camera> path = camera_path(scene_.camera);
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (stop.stop_requested()) return;
        view.camera = path[i];
        candidate.renderer->render(view);
        const Image picture = candidate.renderer->read_picture();
        const double error = mean_difference(path_references_[i], picture, Metric::rmse);
        if (!std::isfinite(error))
            return candidate.refuse(
                fmt::format("Its picture {} of {} on the camera path has colours that are infinite or NaN",
                            i + 1, path.size()));
        if (before)
            candidate.numbers.stability = std::max(candidate.numbers.stability, std::abs(error - *before));
        before = error;
    }
}

void ChartBench::finish(Candidate& candidate, const std::stop_token& stop) const {
    if (candidate.renderer == nullptr) return;
    ChartNumbers& numbers = candidate.numbers;
    numbers.moments = spread_of(candidate.moments);
    numbers.color = spread_of(candidate.color);
    numbers.composite = spread_of(candidate.composite);
    numbers.total = spread_of(candidate.total);
    numbers.differential = spread_of(candidate.differential);
    follow_path(candidate, stop);
}

void ChartBench::begin(std::span<const Configuration> block) {
    candidates_.clear();
    for (const Configuration& configuration : block) candidates_.emplace_back().configuration = configuration;
    block_size_ = block.size();
    done_ = 0;
}

void ChartBench::advance(const std::stop_token& stop) {
    assert(!finished());
    const std::size_t place = done_ % block_size_;
    const std::size_t turn = done_ / block_size_;
    if (turn == 0)
        prepare(candidates_[place], stop);
    else if (turn <= static_cast<std::size_t>(settings_.repeat))
        time(place);
    else
        finish(candidates_[place], stop);
    ++done_;
}

std::vector<ChartRow> ChartBench::rows() const {
    assert(finished());
    std::vector<ChartRow> rows;
    for (const Candidate& candidate : candidates_) rows.push_back(candidate.row(scene_.id));
    return rows;
}

std::vector<ChartRow> ChartBench::measure(std::span<const Configuration> block, const std::stop_token& stop,
                                          const std::function<void()>& step) {
    begin(block);
    while (!finished()) {
        if (stop.stop_requested()) return {};
        advance(stop);
        step();
    }
    return stop.stop_requested() ? std::vector<ChartRow>() : rows();
}

}  // namespace momentscope
