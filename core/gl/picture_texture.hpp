// picture_texture.hpp -- pictures that were computed on the CPU, for the screen.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A texture of sRGB RGBA bytes that are given row by row from the top; like the renderer's, its first row is
/// the lowest.
GlTexture make_picture_texture(std::span<const unsigned char> rgba, glm::ivec2 size);

}  // namespace momentscope
