#include "app/image_texture.hpp"

#include <cmath>
#include <vector>

#include "core/gl/texture.hpp"

namespace momentscope {

GlTexture image_texture(const Image& image) {
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * image.pixels.size());
    for (const glm::vec4& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<unsigned char>(std::lround(255 * srgb_from_linear(pixel[c]))));
        bytes.push_back(255);
    }
    GlTexture texture = make_texture(GL_RGBA8, {image.width, image.height});
    write_texture(texture, {image.width, image.height}, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return texture;
}

}  // namespace momentscope
