// camera_path.hpp -- the camera path along which a chart measures popping.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace momentscope {

constexpr int PATH_FRAMES = 8;
constexpr const char* PATH_TEXT = "8 frames of an orbit by 0.5 degrees each, at a quarter of the size";

/// A slow orbit about the target of the camera. The camera itself is in the middle of the path.
std::vector<Camera> camera_path(const Camera& camera);

/// The size of the pictures of the path for a chart of this size.
glm::ivec2 path_size(glm::ivec2 size);

}  // namespace momentscope
