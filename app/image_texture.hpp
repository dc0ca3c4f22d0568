// image_texture.hpp -- textures of pictures in memory, for the panels of written pictures.
#pragma once
#include "core/gl/handle.hpp"
#include "core/image/image.hpp"

namespace momentscope {

/// A texture of sRGB bytes. Its first row is the top row of the picture, as ImGui::Image expects.
GlTexture image_texture(const Image& image);

}  // namespace momentscope
