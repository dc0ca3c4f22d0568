#include "ui/model/comparison.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/compare/worst_pixel.hpp"
#include "ui/model/comparison_map.hpp"

namespace momentscope::ui {

namespace {

std::size_t index_of(Metric metric) {
    return static_cast<std::size_t>(metric);
}

std::optional<MetricResult> measure_pair(const PicturePair& pair, Metric metric,
                                         const std::stop_token& stop) {
    MetricResult result;
    result.metric = metric;
    result.map = difference_map(pair.reference, pair.picture, metric, stop);
    if (result.map.empty()) return std::nullopt;
    result.mean = mean_difference(result.map, metric);
    const auto [least, most] = std::ranges::minmax_element(result.map);
    result.least = *least;
    result.most = *most;
    // If several pixels are equal, take the first one, as "next worst" does.
    const auto at = static_cast<int>(std::ranges::find(result.map, *most) - result.map.begin());
    result.worst = {at % pair.reference.width, at / pair.reference.width};
    return result;
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
        std::optional<MetricResult> result = measure_pair(*pair, metric, stop);
        if (result) result->pair = number;
        return result;
    });
}

const MetricResult* Comparison::result(Metric metric) const {
    const auto& found = results_[index_of(metric)];
    return found ? &*found : nullptr;
}

bool Comparison::is_fresh(Metric metric) const {
    const MetricResult* found = result(metric);
    return found != nullptr && found->pair == number_;
}

double Comparison::mean_of(const MetricResult& result, const PixelRegion& region) {
    RegionMean& known = region_means_[index_of(result.metric)];
    if (known.pair != result.pair || known.region != region)
        known = {result.pair, region, mean_difference(part_of(result.map, size().x, region), result.metric)};
    return known.mean;
}

bool Comparison::update_map(const CompareState& state) {
    const bool colors = state.mode == CompareMode::false_color;
    const MetricResult* shown = colors ? result(state.metric) : nullptr;
    if (colors && shown == nullptr) {
        const bool had = map_.mode != CompareMode::off;
        map_ = {};
        return had;
    }
    const long pair = colors ? shown->pair : number_;
    const bool same_metric = !colors || map_.metric == state.metric;
    if (map_.mode == state.mode && same_metric && map_.gain == state.gain && map_.pair == pair) return false;
    map_.mode = state.mode;
    map_.metric = state.metric;
    map_.gain = state.gain;
    map_.pair = pair;
    map_.rgba =
        colors ? false_color_bytes(shown->map, false_color_end(state)) : difference_bytes(*pair_, state.gain);
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
    return metrics()[index_of(state.metric)].full_scale / state.gain;
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
