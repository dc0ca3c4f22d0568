// image.hpp -- pictures in memory and in files.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "core/image/tone_map.hpp"

namespace momentscope {

/// Linear RGBA floats, row by row from the upper left corner.
struct Image {
    Image() = default;
    Image(int width_, int height_)
        : width(width_),
          height(height_),
          pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

    glm::vec4& at(int x, int y) { return pixels[index(x, y)]; }
    const glm::vec4& at(int x, int y) const { return pixels[index(x, y)]; }
    void flip_rows();

    int width = 0;
    int height = 0;
    std::vector<glm::vec4> pixels;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// The sRGB value in [0, 1] of a linear value (IEC 61966-2-1). Clamps.
float srgb_from_linear(float linear);

/// The linear value of an sRGB value in [0, 1].
float linear_from_srgb(float srgb);

/// Reads a picture in any format that OpenImageIO reads: integers as sRGB, floats as linear. Colours are
/// those of the file, not multiplied by alpha; alpha is 1 if the file has none. Throws Error if the file is
/// not an ordinary file or cannot be read, or if the picture has more than 67 million pixels or a side of
/// more than 16384.
Image read_image(const std::filesystem::path& path);

/// Writes .exr (linear floats) or .png (8-bit sRGB, after the tone map) to a temporary file, which is then
/// renamed. Throws Error if this fails.
void write_image(const Image& image, const std::filesystem::path& path, ToneMap tone_map = ToneMap::none);

/// Writes 8-bit sRGB RGBA bytes, row by row from the top, as .png.
void write_png(const std::vector<unsigned char>& rgba, int width, int height,
               const std::filesystem::path& path);

}  // namespace momentscope
