#include "core/image/image.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/output_file.hpp"

namespace momentscope {

namespace {

void write_pixels(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                  const void* pixels) {
    replace_file(path, [&](const std::filesystem::path& partial) {
        auto file = OIIO::ImageOutput::create(partial.string());
        return file && file->open(partial.string(), spec) && file->write_image(type, pixels) && file->close();
    });
}

}  // namespace

void Image::flip_rows() {
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(&at(0, y), &at(0, y) + width, &at(0, height - 1 - y));
}

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

void write_image(const Image& image, const std::filesystem::path& path) {
    if (path.extension() == ".exr") {
        const OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::FLOAT);
        write_pixels(path, spec, OIIO::TypeDesc::FLOAT, image.pixels.data());
        return;
    }
    std::vector<unsigned char> bytes;
    bytes.reserve(image.pixels.size() * 4);
    for (const glm::vec4& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<unsigned char>(std::lround(255.0f * srgb_from_linear(pixel[c]))));
        bytes.push_back(255);
    }
    write_png(bytes, image.width, image.height, path);
}

void write_png(const std::vector<unsigned char>& rgba, int width, int height,
               const std::filesystem::path& path) {
    if (path.extension() != ".png")
        throw Error(fmt::format("'{}' is no kind of picture that can be written; end it in .png or .exr.",
                                path.string()));
    const OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
    write_pixels(path, spec, OIIO::TypeDesc::UINT8, rgba.data());
}

double rms_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double difference =
                static_cast<double>(a.pixels[i][c]) - static_cast<double>(b.pixels[i][c]);
            sum += difference * difference;
        }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

}  // namespace momentscope
