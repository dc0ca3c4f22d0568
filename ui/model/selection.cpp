#include "ui/model/selection.hpp"

#include <algorithm>
#include <utility>

#include "core/scene/camera.hpp"
#include "core/shadow/shadow_settings.hpp"

namespace momentscope::ui {

namespace {

// What belongs to a ray: a mark in it, and a query depth and ranges on its axis.
void forget_ray(ExplorerState& state) {
    state.marked.reset();
    state.plot.query.reset();
    fit(state.plot);
}

}  // namespace

glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size) {
    return (glm::vec2(glm::clamp(pixel, glm::ivec2(0), size - 1)) + 0.5f) / glm::vec2(size);
}

glm::ivec2 pixel_of(const std::optional<glm::vec2>& fraction, const Scene& scene, glm::ivec2 size) {
    if (!fraction) return picked_pixel(scene, size);
    return glm::clamp(glm::ivec2(glm::floor(*fraction * glm::vec2(size))), glm::ivec2(0), size - 1);
}

void choose_scene(ExplorerState& state, const std::string& id_or_path) {
    state.scene = id_or_path;
    state.ray.reset();
    state.picked.reset();
    state.receiver.reset();
    forget_ray(state);
    reset_camera(state);
    remove_pins(state);
    forget_region(state.compare);
}

void open_ray(ExplorerState& state, ViewRay ray) {
    state.ray = std::move(ray);
    forget_ray(state);
}

void edit_ray(ExplorerState& state, ViewRay ray) {
    open_ray(state, std::move(ray));
    state.panel = Panel::editor;
}

void change_ray(ExplorerState& state, ViewRay ray) {
    state.ray = std::move(ray);
}

void leave_ray(ExplorerState& state) {
    state.ray.reset();
    forget_ray(state);
}

void delete_marked(ExplorerState& state) {
    if (!state.ray || !state.marked || *state.marked >= state.ray->fragments.size()) return;
    ViewRay ray = *state.ray;
    ray.fragments.erase(ray.fragments.begin() + static_cast<std::ptrdiff_t>(*state.marked));
    change_ray(state, std::move(ray));
    state.marked.reset();
}

void pick(ExplorerState& state, glm::vec2 fraction) {
    if (state.picked == fraction) return;
    state.picked = fraction;
    state.marked.reset();
    state.receiver.reset();
}

void move_pick(ExplorerState& state, const Measurement& measurement, glm::ivec2 by) {
    if (measurement.picture_size.x > 0)
        pick(state, fraction_of(measurement.pixel + by, measurement.picture_size));
}

std::optional<glm::ivec2> next_place(const std::vector<glm::ivec2>& places, glm::ivec2 from) {
    constexpr int APART = 16;  // in a row of the picture; rows in between are skipped, too
    const auto is_behind = [&](glm::ivec2 place) {
        const glm::ivec2 way = place - from;
        return (way.y == 0 && way.x >= APART) || way.y >= APART;
    };
    const auto found = std::ranges::find_if(places, is_behind);
    if (found != places.end()) return *found;
    return places.empty() ? std::nullopt : std::optional(places.front());
}

bool toggle_pin(ExplorerState& state, const Measurement& measurement) {
    if (state.ray || measurement.picture_size.x < 1) return true;
    const glm::vec2 here = state.picked.value_or(fraction_of(measurement.pixel, measurement.picture_size));
    if (std::erase(state.pins, here) > 0) return true;
    if (state.pins.size() >= MAX_PINS) return false;
    state.pins.push_back(here);
    return true;
}

void remove_pin(ExplorerState& state, std::size_t index) {
    state.pins.erase(state.pins.begin() + static_cast<std::ptrdiff_t>(index));
}

void remove_pins(ExplorerState& state) {
    state.pins.clear();
}

void mark(ExplorerState& state, std::optional<std::size_t> fragment) {
    state.marked = fragment;
    if (fragment) state.plot.query.reset();
}

void toggle_mark(ExplorerState& state, std::size_t fragment) {
    if (state.marked == fragment)
        state.marked.reset();
    else
        state.marked = fragment;
    state.plot.query.reset();
}

void mark_next(ExplorerState& state, const Measurement& measurement, int step) {
    const auto& rows = measurement.history;
    if (rows.empty()) return;
    const auto count = static_cast<int>(rows.size());
    int place = step > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (state.marked == rows[static_cast<std::size_t>(i)].fragment) place = i;
    place = std::clamp(place + step, 0, count - 1);
    mark(state, rows[static_cast<std::size_t>(place)].fragment);
}

bool seen_from_light(const ExplorerState& state) {
    return state.viewpoint != Viewpoint::eye && !state.ray && has_shadows(state.parameters);
}

void set_viewpoint(ExplorerState& state, Viewpoint viewpoint) {
    const bool before = state.viewpoint != Viewpoint::eye, after = viewpoint != Viewpoint::eye;
    const std::optional<std::size_t> marked = state.marked;
    forget_ray(state);
    if (viewpoint == state.viewpoint) {
        state.marked = marked;  // the ray is the same
    } else if (before && !after) {
        state.marked = state.receiver;
    } else if (after && !before) {
        state.parameters.turn(ParameterId::shadows, true);
        state.receiver = marked;
    }
    state.viewpoint = viewpoint;
}

void fit(PlotState& plot) {
    fit_depths(plot);
    fit_values(plot);
}

void fit_depths(PlotState& plot) {
    plot.depth.reset();
}

void fit_values(PlotState& plot) {
    plot.value.reset();
}

void set_quantity(PlotState& plot, Quantity quantity) {
    plot.quantity = quantity;
    fit_values(plot);
}

void set_depth_axis(PlotState& plot, DepthAxis axis) {
    plot.axis = axis;
    fit_depths(plot);
}

void reset_camera(ExplorerState& state) {
    state.camera.reset();
}

void forget_region(CompareState& compare) {
    compare.region.reset();
}

void close_card(ExplorerState& state) {
    state.card.clear();
    state.step = 0;
    state.hint = state.answer = false;
}

}  // namespace momentscope::ui
