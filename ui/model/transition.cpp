#include "ui/model/transition.hpp"

#include <cmath>
#include <glm/glm.hpp>

namespace momentscope::ui {

namespace {

// Slow at both ends.
float eased(float share) {
    return share * share * (3 - 2 * share);
}

bool moves(const Parameter& row) {
    return row.scale == Scale::linear || row.scale == Scale::logarithmic;
}

void move_parameters(const ParameterValues& from, float share, ParameterValues& values) {
    for (const Parameter& row : parameters()) {
        const auto first = from[row.id];
        const auto last = values[row.id];
        if (!moves(row) || !first || !last || *first == *last) continue;
        const bool logarithmic = row.scale == Scale::logarithmic && *first > 0 && *last > 0;
        values.set(row.id, logarithmic ? std::exp(glm::mix(std::log(*first), std::log(*last), share))
                                       : glm::mix(*first, *last, share));
    }
}

ViewRay moved(const ViewRay& from, const ViewRay& to, float share) {
    ViewRay ray = to;
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const Fragment& first = from.fragments[i];
        Fragment& fragment = ray.fragments[i];
        fragment.depth = glm::mix(first.depth, fragment.depth, share);
        fragment.view_depth = glm::mix(first.view_depth, fragment.view_depth, share);
        fragment.opacity = glm::mix(first.opacity, fragment.opacity, share);
        fragment.color = glm::mix(first.color, fragment.color, share);
    }
    return ray;
}

}  // namespace

ExplorerState between(const ExplorerState& from, const ExplorerState& to, float share) {
    if (share >= 1) return to;
    const float t = eased(share);
    ExplorerState state = to;
    move_parameters(from.parameters, t, state.parameters);
    const bool same_scene =
        from.scene == to.scene && static_cast<bool>(from.ray) == static_cast<bool>(to.ray);
    if (!same_scene) return state;
    if (from.plot.query && to.plot.query) state.plot.query = glm::mix(*from.plot.query, *to.plot.query, t);
    if (from.picked && to.picked) state.picked = glm::mix(*from.picked, *to.picked, t);
    if (from.ray && to.ray && from.ray->fragments.size() == to.ray->fragments.size() &&
        from.ray->warp == to.ray->warp)
        state.ray = moved(*from.ray, *to.ray, t);
    if (from.camera && to.camera) {
        state.camera->target = glm::mix(from.camera->target, to.camera->target, t);
        state.camera->distance = glm::mix(from.camera->distance, to.camera->distance, t);
        state.camera->azimuth = glm::mix(from.camera->azimuth, to.camera->azimuth, t);
        state.camera->elevation = glm::mix(from.camera->elevation, to.camera->elevation, t);
    }
    return state;
}

}  // namespace momentscope::ui
