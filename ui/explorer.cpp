// explorer.cpp -- computes what is shown from the state: which stages run again, and when.
#include "ui/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/scene/camera.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"

namespace momentscope::ui {

Explorer::Explorer(Renderer& renderer, ExplorerState state, ExplorerOptions options)
    : renderer_(renderer),
      options_(options),
      state_(std::move(state)),
      shown_state_(state_),
      history_(state_),
      draft_(renderer.programs()) {}

// The last change may not be recorded as a step yet.
void Explorer::undo() {
    history_.record(state_);
    if (history_.can_undo()) state_ = history_.undo();
}

void Explorer::redo() {
    history_.record(state_);
    if (history_.can_redo()) state_ = history_.redo();
}

void Explorer::move_pick(glm::ivec2 by) {
    if (measurement_.picture_size.x > 0)
        pick(state_, fraction_of(measurement_.pixel + by, measurement_.picture_size));
}

void Explorer::toggle_pin() {
    if (state_.ray || measurement_.picture_size.x < 1) return;
    const glm::vec2 here = state_.picked.value_or(fraction_of(measurement_.pixel, measurement_.picture_size));
    if (std::erase(state_.pins, here) > 0) return;
    if (state_.pins.size() < MAX_PINS)
        state_.pins.push_back(here);
    else
        message_ = "Four pixels are pinned already, and there is no room for more; remove one first.";
}

void Explorer::mark_next(int step) {
    const auto& rows = measurement_.history;
    if (rows.empty()) return;
    const auto count = static_cast<int>(rows.size());
    int place = step > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (state_.marked == rows[static_cast<std::size_t>(i)].fragment) place = i;
    place = std::clamp(place + step, 0, count - 1);
    state_.marked = rows[static_cast<std::size_t>(place)].fragment;
    state_.plot.query.reset();
}

void Explorer::type_parameter(ParameterId id) {
    state_.panel = Panel::controls;
    to_type_ = id;
}

// Dialogs and text fields close themselves on Escape; this function closes the rest.
void Explorer::close_topmost() {
    if (palette_.is_open())
        palette_.close();
    else if (escape_is_taken_)
        return;
    else if (help_)
        help_ = false;
    else if (!message_.empty())
        message_.clear();
    else if (state_.compare.region)
        state_.compare.region.reset();
    else
        state_.card.clear();
}

// Discards a state that could not be shown.
void Explorer::go_back_to_shown() {
    history_.reject_present(shown_state_);
    state_ = shown_state_;
}

// If a scene cannot be loaded, shows the error and goes back to the state that is shown.
void Explorer::poll_loader() {
    if (!loader_.busy()) return;
    try {
        if (std::optional<Scene> scene = loader_.take()) show_scene(*std::move(scene));
    } catch (const Error& error) {
        if (scene_.id.empty()) throw;
        message_ = error.what();
        go_back_to_shown();
    }
}

void Explorer::load_scene_if_changed() {
    if (state_.scene == scene_.id) return apply_opacity();
    const float opacity = state_.parameters.number(ParameterId::opacity);
    if (!is_builtin_scene(state_.scene)) return loader_.start(state_.scene, opacity);
    show_scene(load_scene(state_.scene, opacity));
}

std::string Explorer::warning() const {
    return fmt::format("{}", fmt::join(scene_.warnings, " "));
}

void Explorer::show_scene(Scene scene) {
    renderer_.set_scene(scene);
    draft_.set_scene(scene);
    reference_.reset();
    scene_ = std::move(scene);
    light_distance_ = standard_light_distance(caster_bounds(scene_));
    if (!scene_.warnings.empty()) message_ = warning();
    shown_view_.technique = nullptr;
    apply_opacity();
}

// Opacity is a parameter of mesh files only; built-in scenes have their own opacities.
void Explorer::apply_opacity() {
    if (is_builtin_scene(scene_.id)) return;
    const float opacity = state_.parameters.number(ParameterId::opacity);
    bool changed = false;
    for (Object& object : scene_.objects) {
        changed |= !object.opaque() && object.opacity != opacity;
        if (!object.opaque()) object.opacity = opacity;
    }
    if (!changed) return;
    renderer_.set_scene(scene_);
    draft_.set_objects(scene_.objects);
    reference_.reset();
    shown_view_.technique = nullptr;
}

void Explorer::update(glm::ivec2 size) {
    report_ = {};
    try {
        poll_loader();
        if (is_loading_scene()) return;  // the old content stays until the scene is loaded
        if (state_.ray)
            update_ray();
        else
            update_picture(size);
        if (is_loading_scene()) return;
        shown_state_ = state_;
        update_sharp_bounds();
    } catch (const Error& error) {
        if (measurement_.curve.technique == nullptr) throw;  // there is no good state to show
        message_ = error.what();
        go_back_to_shown();
        shown_view_.technique = nullptr;
        worst_wanted_ = false;
    }
}

void Explorer::update_ray() {
    comparison_.stop();
    worst_wanted_ = false;
    const bool changed = !(shown_state_.ray == state_.ray) || measurement_.curve.technique == nullptr;
    if (changed) {
        measurement_.capture = {.ray = *state_.ray, .transmittance = {}, .stored = {}};
        measurement_.light.reset();
        measurement_.pins.clear();
        shown_view_.technique = nullptr;  // the picture is no longer shown
    }
    measure_if_changed(changed);
}

void Explorer::update_picture(glm::ivec2 size) {
    const auto begun = std::chrono::steady_clock::now();
    leave_light_without_shadows();
    const bool builds_scene = state_.scene != scene_.id && is_builtin_scene(state_.scene);
    if (builds_scene)
        announce(picture_kind({camera(), size, state_.technique, state_.parameters}, Stage::opaque), size);
    load_scene_if_changed();
    if (is_loading_scene()) return;
    const View view = {camera(), size, state_.technique, state_.parameters};
    const Stage stage = first_stale_stage(shown_view_, view);
    const PassCounts before = renderer_.pass_counts();
    if (wants_draft(view, stage)) return draw_draft(view, stage);
    const PictureKind kind = picture_kind(view, stage);
    if (!builds_scene) announce(kind, size);
    draft_view_.technique = nullptr;
    if (stage != Stage::nothing) renderer_.render(view);
    report_passes(before);
    update_comparison(view, stage);  // this may pick another pixel
    update_capture(view, stage);
    update_pins(view, stage);
    update_scene_picture(view, stage);
    shown_view_ = view;
    measure_if_changed(report_.capture);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    picture_times_.took(kind, size, took.count());
}

void Explorer::report_passes(const PassCounts& before) {
    const PassCounts& now = renderer_.pass_counts();
    report_.opaque = now.opaque > before.opaque;
    report_.first_pass = now.moments > before.moments;
    report_.second_pass = now.color > before.color;
    report_.composite = now.composite > before.composite;
}

bool Explorer::fragments_stale(const View& view, Stage stage) const {
    if (stage <= Stage::opaque || light_changed(shown_view_, view)) return true;  // new colours
    const bool reordered = std::ranges::any_of(PICTURE_PARAMETERS, [&](ParameterId id) {
        return parameter(id).invalidates <= Stage::moments &&
               view.parameters[id] != shown_view_.parameters[id];
    });
    const bool mixed = stage <= Stage::moments && view.technique->uses(ParameterId::resolution);
    return reordered || mixed ||
           view.parameters[ParameterId::resolution] != shown_view_.parameters[ParameterId::resolution];
}

// After the opaque pass, the fragments of a pixel depend only on their order and on what low-resolution
// moments mix. The T of the second pass is captured only if it is shown.
void Explorer::update_capture(const View& view, Stage stage) {
    const glm::ivec2 pixel = pixel_of(state_.picked, scene_, view.size);
    const bool light = seen_from_light(state_);
    const bool moved =
        fragments_stale(view, stage) || pixel != measurement_.pixel || draft_captured_ ||
        light != measurement_.light.has_value() ||
        (light && (state_.receiver != shown_state_.receiver || state_.viewpoint != shown_state_.viewpoint));
    transmittance_stale_ |= stage <= Stage::color;
    if (!moved && (light || !(transmittance_stale_ && state_.panel == Panel::fragments))) {
        if (transmittance_stale_) measurement_.capture.transmittance.clear();
        return;
    }
    measurement_.capture = renderer_.capture_pixel(pixel);
    measurement_.light.reset();
    if (light) see_from_light(pixel);
    measurement_.pixel = pixel;
    measurement_.picture_size = view.size;
    transmittance_stale_ = false;
    draft_captured_ = false;
    report_.capture = true;
}

void Explorer::update_pins(const View& view, Stage stage) {
    if (!fragments_stale(view, stage) && shown_state_.pins == state_.pins &&
        measurement_.pins.size() == state_.pins.size())
        return;
    measurement_.pins.clear();
    for (const glm::vec2& place : state_.pins) {
        const glm::ivec2 pixel = pixel_of(place, scene_, measurement_.picture_size);
        measurement_.pins.push_back({pixel, renderer_.capture_pixel(pixel).ray, {}});
        report_.capture = true;
    }
    report_.capture |= shown_state_.pins != state_.pins;
}

// Updates what is shown over or instead of the picture: reference, differences, failures, lens.
void Explorer::update_scene_picture(const View& view, Stage stage) {
    picture_.scene_camera = scene_.camera;
    choose_picture();
    if (!state_.failures) {
        picture_.failures.reset();
    } else if (stage <= Stage::color || !shown_state_.failures) {
        picture_.failures = renderer_.draw_failures();
        report_.failures = true;
    }
    const bool own_picture = picture_.texture == renderer_.display_texture();
    picture_.overlay = picture_.failures && own_picture ? renderer_.failure_texture() : 0;
    update_lens(view.size,
                stage != Stage::nothing || report_.reference || report_.comparison || report_.capture);
}

void Explorer::measure_if_changed(bool captured) {
    const bool first = measurement_.curve.technique == nullptr;
    report_.plot = captured || first || !same_curves(shown_state_, state_);
    if (captured || first) sharp_input_.reset();
    if (report_.plot) measure_curves(measurement_, state_);
    breakdown_stale_ |= report_.plot || shown_state_.parameters != state_.parameters;
    if (breakdown_stale_ && state_.panel == Panel::fragments && !measurement_.light) {
        measure_breakdown(measurement_, state_);
        breakdown_stale_ = false;
    }
    report_.query = report_.plot || query_depth(measurement_, state_) != measurement_.canonical.query;
    if (report_.query) measure_query(measurement_, state_);
}

std::optional<std::filesystem::path> Explorer::take_window_export() {
    if (!window_export_ || --frames_to_export_ > 0) return std::nullopt;
    return std::exchange(window_export_, std::nullopt);
}

}  // namespace momentscope::ui
