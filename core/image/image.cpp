#include "core/image/image.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace momentscope {

namespace {

// Writes beside the target and renames, so that a failure leaves no half file and keeps the old one.
void write_pixels(const std::filesystem::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                  const void* pixels) {
    require_writable(path);
    std::filesystem::path partial = path;
    partial.replace_filename(fmt::format(".{}.partial{}", path.stem().string(), path.extension().string()));
    auto file = OIIO::ImageOutput::create(partial.string());
    const bool written =
        file && file->open(partial.string(), spec) && file->write_image(type, pixels) && file->close();
    std::error_code status;
    if (written) std::filesystem::rename(partial, path, status);
    if (!written || status) {
        std::filesystem::remove(partial, status);
        throw Error(fmt::format("The picture '{}' could not be written; check the folder and free space.",
                                path.string()));
    }
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

void require_writable(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code status;
    if (std::filesystem::is_directory(path, status))
        throw Error(fmt::format("'{}' is a folder; give the name of a file.", path.string()));
    if (!std::filesystem::is_directory(folder, status))
        throw Error(
            fmt::format("There is no folder '{}'; make it first, or write elsewhere.", folder.string()));
    const bool exists = std::filesystem::exists(path, status);
    if (access((exists ? path : folder).c_str(), W_OK) != 0)
        throw Error(
            fmt::format("'{}' cannot be written; check its permissions, or write elsewhere.", path.string()));
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
