// view.hpp -- a picture as a value: what it shows and how, and from which stage a change must be redone.
#pragma once
#include <glm/glm.hpp>

#include "core/image/tone_map.hpp"
#include "core/parameters.hpp"
#include "core/scene/scene.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Everything beside the scene that a picture depends on.
struct View {
    Camera camera;
    glm::ivec2 size{0};
    const Technique* technique = nullptr;
    ParameterValues parameters;
};

/// The curve that every technique's picture is shown with.
ToneMap tone_map_of(const ParameterValues& values);

constexpr int MAX_PICTURE_SIDE = 8192;

/// Does the change alter how surfaces are lit?
bool light_changed(const View& before, const View& after);

/// The first stage that must run again for `after` when `before` was drawn last. Parameters that the
/// technique does not read make nothing stale, but for the tone map, which is none of its business.
Stage first_stale_stage(const View& before, const View& after);

}  // namespace momentscope
