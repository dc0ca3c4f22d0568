// camera_path.hpp -- the recorded camera path along which a chart looks for popping.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace momentscope {

constexpr int PATH_FRAMES = 8;
constexpr const char* PATH_TEXT = "8 frames of an orbit by 0.5 degrees each, at a quarter of the size";

/// A slow orbit about what the camera looks at, with the camera itself in its middle.
std::vector<Camera> camera_path(const Camera& camera);

/// The size of its pictures for a chart of that size.
glm::ivec2 path_size(glm::ivec2 size);

}  // namespace momentscope
