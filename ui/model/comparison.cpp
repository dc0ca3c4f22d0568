#include "ui/model/comparison.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/compare/flip.hpp"
#include "core/compare/worst_pixel.hpp"
#include "core/inspect/color_uncertainty.hpp"
#include "ui/model/comparison_map.hpp"

namespace momentscope::ui {

namespace {

std::size_t index_of(Metric metric) {
    return static_cast<std::size_t>(metric);
}

void find_range(PixelNumbers& numbers) {
    const auto [least, most] = std::ranges::minmax_element(numbers.map);
    numbers.least = *least;
    numbers.most = *most;
}

MetricResult result_of_map(std::vector<float> map, Metric metric, int width) {
    MetricResult result;
    result.metric = metric;
    result.map = std::move(map);
    result.mean = mean_difference(result.map, metric);
    find_range(result);
    // If several pixels are equal, take the first one, as "next worst" does.
    const auto at = static_cast<int>(std::ranges::find(result.map, result.most) - result.map.begin());
    result.worst = {at % width, at / width};
    return result;
}

// FLIP takes long, so it comes in parts.
Sliced<std::optional<MetricResult>> measure_pair(std::shared_ptr<const PicturePair> pair, Metric metric,
                                                 long number, std::stop_token stop) {
    std::vector<float> map;
    if (metric == Metric::flip) {
        FlipParts flip(pair->reference, pair->picture);
        co_await Parts(
            flip.count(), [&](std::size_t part) { flip.run(part); }, stop);
        if (!stop.stop_requested()) map = flip.map();
    } else {
        map = difference_map(pair->reference, pair->picture, metric, stop);
    }
    if (map.empty()) co_return std::nullopt;
    MetricResult result = result_of_map(std::move(map), metric, pair->reference.width);
    result.of = number;
    co_return result;
}

}  // namespace

glm::ivec2 Comparison::size() const {
    return has_pair() ? glm::ivec2(pair_->picture.width, pair_->picture.height) : glm::ivec2(0);
}

void Comparison::set_pair(PicturePair pair) {
    if (glm::ivec2(pair.picture.width, pair.picture.height) != size()) {
        results_ = {};
        map_ = {};
        work_.cancel();
    }
    pair_ = std::make_shared<const PicturePair>(std::move(pair));
    ++number_;
}

// While a control is dragged, every frame has a new pair, so a result always belongs to an older pair.
// Showing it is better than showing nothing until the drag ends.
void Comparison::poll() {
    std::optional<std::optional<MetricResult>> done = work_.take();
    if (!done || !*done || work_.cancelled()) return;
    const Metric metric = (*done)->metric;
    results_[index_of(metric)] = std::move(*done);
}

void Comparison::work_on(Metric first, bool all) {
    if (work_.busy()) return;
    if (!is_fresh(first)) {
        start(first);
    } else if (all) {
        const auto stale =
            std::ranges::find_if(metrics(), [&](const MetricRow& row) { return !is_fresh(row.id); });
        if (stale != metrics().end()) start(stale->id);
    }
}

void Comparison::start(Metric metric) {
    work_.start([pair = pair_, metric, number = number_](const std::stop_token& stop, const auto&) {
        return measure_pair(pair, metric, number, stop);
    });
}

const MetricResult* Comparison::result(Metric metric) const {
    const auto& found = results_[index_of(metric)];
    return found ? &*found : nullptr;
}

bool Comparison::is_fresh(Metric metric) const {
    const MetricResult* found = result(metric);
    return found != nullptr && found->of == number_;
}

double Comparison::mean_of(const MetricResult& result, const PixelRegion& region) {
    RegionMean& known = region_means_[index_of(result.metric)];
    if (known.pair != result.of || known.region != region)
        known = {result.of, region, mean_difference(part_of(result.map, size().x, region), result.metric)};
    return known.mean;
}

void Comparison::set_uncertainty(std::vector<float> map, glm::ivec2 size) {
    PixelNumbers numbers = {.map = std::move(map), .of = uncertainty_ ? uncertainty_->of + 1 : 1};
    find_range(numbers);
    uncertainty_ = std::move(numbers);
    uncertainty_size_ = size;
}

const PixelNumbers* Comparison::false_color_numbers(const CompareState& state) const {
    if (state.mode == CompareMode::uncertainty) return uncertainty();
    return state.mode == CompareMode::false_color ? result(state.metric) : nullptr;
}

bool Comparison::update_map(const CompareState& state) {
    const bool differences = state.mode == CompareMode::difference;
    const PixelNumbers* shown = false_color_numbers(state);
    if (!differences && shown == nullptr) {
        const bool had = map_.mode != CompareMode::off;
        map_ = {};
        return had;
    }
    const long of = differences ? number_ : shown->of;
    const bool same_metric = state.mode != CompareMode::false_color || map_.metric == state.metric;
    if (map_.mode == state.mode && same_metric && map_.gain == state.gain && map_.of == of) return false;
    map_ = {.mode = state.mode, .metric = state.metric, .gain = state.gain, .of = of};
    map_.size = state.mode == CompareMode::uncertainty ? uncertainty_size_ : size();
    if (!differences) map_.numbers = shown->map;
    map_.rgba = differences ? difference_bytes(*pair_, state.gain)
                            : false_color_bytes(shown->map, false_color_end(state));
    return true;
}

std::optional<glm::ivec2> Comparison::next_worst(Metric metric, const PixelRegion& region) {
    assert(is_fresh(metric));
    if (visited_pair_ != number_ || visited_metric_ != metric || visited_region_ != region) visited_.clear();
    visited_pair_ = number_;
    visited_metric_ = metric;
    visited_region_ = region;
    const std::vector<float>& map = result(metric)->map;
    auto pixel = next_worst_pixel(map, size().x, region, visited_);
    if (!pixel && !visited_.empty()) {  // all pixels were visited: start again
        visited_.clear();
        pixel = next_worst_pixel(map, size().x, region, visited_);
    }
    if (pixel) visited_.push_back(*pixel);
    return pixel;
}

float false_color_end(const CompareState& state) {
    const bool open = state.mode == CompareMode::uncertainty;
    return (open ? OPEN_FULL_SCALE : metrics()[index_of(state.metric)].full_scale) / state.gain;
}

PixelRegion pixels_of(const std::optional<PictureRegion>& region, glm::ivec2 size) {
    if (!region) return {0, 0, size.x, size.y};
    const glm::vec2 extent(size);
    const glm::ivec2 low = glm::clamp(glm::ivec2(glm::round(region->low * extent)), glm::ivec2(0), size - 1);
    const glm::ivec2 high = glm::clamp(glm::ivec2(glm::round(region->high * extent)), low + 1, size);
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

PictureRegion region_between(glm::ivec2 one, glm::ivec2 other, glm::ivec2 size) {
    const glm::ivec2 low = glm::clamp(glm::min(one, other), glm::ivec2(0), size - 1);
    const glm::ivec2 high = glm::clamp(glm::max(one, other), glm::ivec2(0), size - 1) + 1;
    return {glm::vec2(low) / glm::vec2(size), glm::vec2(high) / glm::vec2(size)};
}

}  // namespace momentscope::ui
