// camera_moves.hpp -- camera movements by the mouse and by named views.
#pragma once
#include <span>

#include "core/scene/scene.hpp"

namespace momentscope::ui {

struct NamedView {
    const char* id;
    const char* name;
    float azimuth, elevation;
};
std::span<const NamedView> named_views();

/// The same camera, turned to a named direction.
Camera looking_from(Camera camera, const NamedView& view);

/// The camera after a mouse movement in pixels.
Camera orbited(Camera camera, glm::vec2 moved);
Camera panned(Camera camera, glm::vec2 moved, glm::ivec2 picture_size);

/// Moves towards the target if `notches` is positive.
Camera zoomed(Camera camera, float notches);

}  // namespace momentscope::ui
