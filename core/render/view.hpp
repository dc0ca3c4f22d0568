// view.hpp -- a picture as a value, and the first stage that a change makes stale.
#pragma once
#include <glm/glm.hpp>

#include "core/image/tone_map.hpp"
#include "core/parameters/parameters.hpp"
#include "core/scene/scene.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Everything that a picture depends on, except the scene.
struct View {
    Camera camera;
    glm::ivec2 size{0};
    const Technique* technique = nullptr;
    ParameterValues parameters;
};

/// The tone map of the picture, which no technique reads.
ToneMap tone_map_of(const ParameterValues& values);

constexpr int MAX_PICTURE_SIDE = 8192;

/// True if the change alters how surfaces are lit.
bool light_changed(const View& before, const View& after);

/// The first stage that must run again for `after` if `before` was drawn last. Parameters that neither the
/// technique nor the picture itself (PICTURE_PARAMETERS) reads make nothing stale.
Stage first_stale_stage(const View& before, const View& after);

}  // namespace momentscope
