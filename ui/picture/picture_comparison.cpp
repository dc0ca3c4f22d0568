#include "ui/picture/picture_comparison.hpp"

#include <fmt/format.h>

#include "core/gl/picture_texture.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

bool has_comparison(const ExplorerState& state) {
    return !state.ray && state.technique != state.compare.reference;
}

bool shows_uncertainty(const ExplorerState& state) {
    return !state.ray && state.technique->has_moments() && state.compare.mode == CompareMode::uncertainty;
}

View reference_view(const ExplorerState& state, const View& view) {
    return {view.camera, view.size, state.compare.reference, view.parameters};
}

bool PictureComparison::wants_reference(const ExplorerState& state) const {
    const CompareMode mode = state.compare.mode;
    const bool shown = mode != CompareMode::off && mode != CompareMode::uncertainty;
    return has_comparison(state) &&
           (flipped_ || shown || state.panel == Panel::compare || worst_wanted_ || error_wanted_);
}

void PictureComparison::update_uncertainty(const Update& update, glm::ivec2 size, Renderer& renderer) {
    if (!shows_uncertainty(update.state)) return;
    if (uncertainty_stale_) numbers_.set_uncertainty(renderer.uncertainty(), size);
    uncertainty_stale_ = false;
    update_map(update);
}

void PictureComparison::update_map(const Update& update) {
    if (!numbers_.update_map(update.state.compare)) return;
    const ComparisonMap& made = numbers_.map();
    map_texture_ = made.mode == CompareMode::off ? GlTexture() : make_picture_texture(made.rgba, made.size);
    update.report.comparison = true;
}

void PictureComparison::update(const Update& update, const PictureChange& change, Renderer& renderer,
                               const Scene& scene) {
    const ExplorerState& state = update.state;
    pair_stale_ |= change.stage != Stage::nothing;
    uncertainty_stale_ |= change.stage <= Stage::color;
    update_uncertainty(update, change.now.size, renderer);
    const CompareMode mode = has_comparison(state) ? state.compare.mode : CompareMode::off;
    const bool map = mode == CompareMode::difference || mode == CompareMode::false_color;
    const bool panel = state.panel == Panel::compare;
    const bool numbers = has_comparison(state) && (map || panel || worst_wanted_ || error_wanted_);
    if (wants_reference(state)) {
        update.report.reference =
            reference_.draw(reference_view(state, change.now), scene, renderer.programs());
        pair_stale_ |= update.report.reference;
    }
    if (!numbers) {
        if (worst_wanted_)
            update.status.say("The picture is drawn with the reference itself; choose another reference.");
        return stop();
    }
    if (pair_stale_) numbers_.set_pair({reference_.picture(), renderer.read_picture()});
    pair_stale_ = false;
    if (mode == CompareMode::false_color || panel || worst_wanted_)
        numbers_.work_on(state.compare.metric, panel);
    else if (error_wanted_)
        numbers_.work_on(Metric::rmse, false);
    else
        numbers_.stop();
    if (map) update_map(update);
    if (worst_wanted_ && numbers_.is_fresh(state.compare.metric)) pick_next_worst(update);
}

void PictureComparison::stop() {
    numbers_.stop();
    worst_wanted_ = false;
}

void PictureComparison::pick_next_worst(const Update& update) {
    worst_wanted_ = false;
    const CompareState& compare = update.state.compare;
    const PixelRegion region = pixels_of(compare.region, numbers_.size());
    const auto pixel = numbers_.next_worst(compare.metric, region);
    if (!pixel) {
        update.status.say(fmt::format("No pixel of the {} differs from the reference.",
                                      compare.region ? "region" : "picture"));
        return;
    }
    pick(update.state, fraction_of(*pixel, numbers_.size()));
    const MetricResult& result = *numbers_.result(compare.metric);
    const auto at = static_cast<std::size_t>(pixel->y * numbers_.size().x + pixel->x);
    update.status.say(fmt::format("Worst pixel {}: {} {:.4g} at {}, {}.", numbers_.visited(),
                                  metrics()[static_cast<std::size_t>(compare.metric)].symbol, result.map[at],
                                  pixel->x, pixel->y));
}

}  // namespace momentscope::ui
