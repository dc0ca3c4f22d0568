// image_texture.hpp -- pictures in memory, for panels of written pictures.
#pragma once
#include "core/gl/handle.hpp"
#include "core/image/image.hpp"

namespace momentscope {

/// A texture of sRGB bytes whose first row is the picture's upper one, as ImGui::Image expects it.
GlTexture image_texture(const Image& image);

}  // namespace momentscope
