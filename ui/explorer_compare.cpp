// explorer_compare.cpp -- picture and reference: which passes, numbers and maps are stale.
#include <fmt/format.h>

#include "ui/explorer.hpp"
#include "ui/technique_combo.hpp"

namespace momentscope::ui {

bool Explorer::has_comparison() const {
    return !state_.ray && state_.technique != state_.compare.reference;
}

// The reference is drawn only if it is shown, compared with or needed for the worst pixel.
bool Explorer::wants_reference() const {
    return has_comparison() && (flipped_ || state_.compare.mode != CompareMode::off ||
                                state_.panel == Panel::compare || worst_wanted_);
}

View Explorer::reference_view(const View& view) const {
    return {view.camera, view.size, state_.compare.reference, view.parameters};
}

void Explorer::update_comparison(const View& view, Stage stage) {
    pair_stale_ |= stage != Stage::nothing;
    const CompareMode mode = has_comparison() ? state_.compare.mode : CompareMode::off;
    const bool map = mode == CompareMode::difference || mode == CompareMode::false_color;
    const bool panel = state_.panel == Panel::compare;
    const bool numbers = has_comparison() && (map || panel || worst_wanted_);
    if (wants_reference()) {
        render_reference(view);
        pair_stale_ |= report_.reference;
    }
    if (!numbers) {
        comparison_.stop();
        if (worst_wanted_)
            message_ = "The picture is drawn with the reference itself; choose another reference.";
        worst_wanted_ = false;
        return;
    }
    if (pair_stale_) comparison_.set_pair({reference_->read_picture(), renderer_.read_picture()});
    pair_stale_ = false;
    if (mode == CompareMode::false_color || panel || worst_wanted_)
        comparison_.work_on(state_.compare.metric, panel);
    else
        comparison_.stop();
    if (map) report_.comparison = comparison_.update_map(state_.compare);
    if (worst_wanted_ && comparison_.is_fresh(state_.compare.metric)) pick_next_worst();
}

void Explorer::render_reference(const View& view) {
    if (reference_ == nullptr) {
        reference_ = std::make_unique<Renderer>(renderer_.programs());
        reference_->set_scene(scene_);
    }
    const int before = reference_->pass_counts().composite;
    reference_view_ = reference_view(view);
    reference_->render(reference_view_);
    report_.reference = reference_->pass_counts().composite > before;
}

void Explorer::pick_next_worst() {
    worst_wanted_ = false;
    const CompareState& compare = state_.compare;
    const PixelRegion region = pixels_of(compare.region, comparison_.size());
    const auto pixel = comparison_.next_worst(compare.metric, region);
    if (!pixel) {
        message_ = fmt::format("No pixel of the {} differs from the reference.",
                               compare.region ? "region" : "picture");
        return;
    }
    pick(state_, fraction_of(*pixel, comparison_.size()));
    const MetricResult& result = *comparison_.result(compare.metric);
    const auto at = static_cast<std::size_t>(pixel->y * comparison_.size().x + pixel->x);
    message_ = fmt::format("Worst pixel {}: {} {:.4g} at {}, {}.", comparison_.visited(),
                           metrics()[static_cast<std::size_t>(compare.metric)].symbol, result.map[at],
                           pixel->x, pixel->y);
}

// Chooses what is shown in the picture's place: the picture, the reference, or a map of their difference.
void Explorer::choose_picture() {
    const CompareState& compare = state_.compare;
    picture_.texture = renderer_.display_texture();
    picture_.beside = 0;
    picture_.legend.reset();
    picture_.title.clear();
    if (flipped_) {
        if (has_comparison()) picture_.texture = reference_->display_texture();
        picture_.title = fmt::format("reference: {}", technique_label(*compare.reference));
        return;
    }
    if (compare.mode == CompareMode::off) return;
    if (!has_comparison()) {
        picture_.title = "nothing to compare: the picture is the reference itself";
        return;
    }
    if (compare.mode == CompareMode::wipe) {
        picture_.beside = reference_->display_texture();
        return;
    }
    const ComparisonMap& map = comparison_.map();
    if (map.mode == compare.mode) picture_.texture = map.texture;
    if (compare.mode == CompareMode::difference)
        picture_.title = fmt::format("|{} - {}| × {:.3g}, linear channels", state_.technique->id,
                                     compare.reference->id, compare.gain);
    else if (const MetricResult* result = comparison_.result(compare.metric))
        picture_.legend = {compare.metric, false_color_end(compare), result->least, result->most,
                           !comparison_.is_fresh(compare.metric)};
    else
        picture_.title =
            fmt::format("{}: computing…", metrics()[static_cast<std::size_t>(compare.metric)].name);
}

}  // namespace momentscope::ui
