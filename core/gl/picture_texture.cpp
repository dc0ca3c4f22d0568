#include "core/gl/picture_texture.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/gl/texture.hpp"

namespace momentscope {

GlTexture make_picture_texture(std::span<const unsigned char> rgba, glm::ivec2 size) {
    const auto row = 4 * static_cast<std::size_t>(size.x);
    std::vector<unsigned char> flipped;
    flipped.reserve(rgba.size());
    for (auto y = static_cast<std::size_t>(size.y); y-- > 0;) {
        const auto bytes = rgba.subspan(y * row, row);
        flipped.insert(flipped.end(), bytes.begin(), bytes.end());
    }
    GlTexture texture = make_texture(GL_RGBA8, size);
    write_texture(texture, size, GL_RGBA, GL_UNSIGNED_BYTE, flipped.data());
    check_gl(fmt::format("showing a picture of {}x{} pixels", size.x, size.y));
    return texture;
}

}  // namespace momentscope
