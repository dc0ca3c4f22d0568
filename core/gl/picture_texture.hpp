// picture_texture.hpp -- textures for pictures that the CPU computed.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A texture of sRGB RGBA bytes. They are given row by row from the top. Like in textures of the renderer,
/// the first row of the texture is the lowest.
GlTexture make_picture_texture(std::span<const unsigned char> rgba, glm::ivec2 size);

}  // namespace momentscope
