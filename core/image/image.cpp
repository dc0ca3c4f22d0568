#include "core/image/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/image/picture_file.hpp"
#include "core/image/picture_module.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/support/reachable.hpp"

namespace momentscope {

namespace {

// Writes a picture with four channels.
void write_pixels(const std::filesystem::path& path, int width, int height, PictureNumbers numbers,
                  const void* pixels) {
    const PictureCodec& codec = picture_codec();
    const char* const kind = path.extension() == ".exr" ? ".exr" : ".png";
    const std::unique_ptr<PictureBytes> file(codec.encode(kind, width, height, numbers, pixels));
    if (!file)
        throw Error(fmt::format("The picture could not be made ({}); try a smaller --size.",
                                first_sentence(codec.reason())));
    write_file({file->data(), file->size()}, path);
}

/// The indices of red, green and blue in the values of a pixel (equal for a grey picture), and that of alpha.
struct Channels {
    std::array<std::size_t, 3> color;
    std::optional<std::size_t> alpha;
};

// Channels are found by their names, because files may also hold depths and normals. Unnamed channels are
// taken in order.
Channels channels_of(const PictureHeader& header) {
    const std::span<const char* const> names(header.channels, header.channel_count);
    const auto named = [&](std::string_view name) {
        const auto found = std::ranges::find(names, name);
        return found == names.end() ? std::nullopt : std::optional<std::size_t>(found - names.begin());
    };
    const auto red = named("R"), green = named("G"), blue = named("B");
    Channels channels{};
    if (red && green && blue)
        channels.color = {*red, *green, *blue};
    else if (names.size() >= 3 && !named("Y"))
        channels.color = {0, 1, 2};
    else
        channels.color.fill(named("Y").value_or(0));
    if (header.alpha_channel >= 0) channels.alpha = static_cast<std::size_t>(header.alpha_channel);
    return channels;
}

constexpr int MAX_SIDE = 16384;
constexpr std::size_t MAX_PIXELS = std::size_t{1} << 26;  // 67 million, twice as many as 8K has

}  // namespace

void Image::flip_rows() {
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(&at(0, y), &at(0, y) + width, &at(0, height - 1 - y));
}

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

Image read_image(const std::filesystem::path& path) {
    require_reachable(path);
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        throw Error(fmt::format("There is no picture '{}'; give the path of one, or the id of a technique.",
                                path.string()));
    PictureFile file(path, "picture", true);
    const PictureHeader& header = file.header();
    const Channels where = channels_of(header);
    // Files may have hundreds of channels. Only those from the first to the last that are needed are read.
    const auto [least, most] = std::ranges::minmax(where.color);
    const std::size_t first = std::min(least, where.alpha.value_or(least));
    const std::size_t channels = std::max(most, where.alpha.value_or(most)) - first + 1;
    file.require_size(MAX_SIDE, MAX_PIXELS, sizeof(glm::vec4) + channels * sizeof(float));
    Image image(header.width, header.height);
    std::vector<float> values(image.pixels.size() * channels);
    file.read(static_cast<int>(first), static_cast<int>(channels), PictureNumbers::floats, values.data());
    const bool linear = header.holds_floats;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = values[i * channels + where.color[c] - first];
            image.pixels[i][static_cast<int>(c)] = linear ? value : linear_from_srgb(value);
        }
        image.pixels[i].a = where.alpha ? values[i * channels + *where.alpha - first] : 1;
    }
    return image;
}

void write_image(const Image& image, const std::filesystem::path& path, ToneMap tone_map) {
    if (path.extension() == ".exr") {
        write_pixels(path, image.width, image.height, PictureNumbers::floats, image.pixels.data());
        return;
    }
    std::vector<unsigned char> bytes;
    bytes.reserve(image.pixels.size() * 4);
    for (const glm::vec4& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            const float shown = tone_mapped(std::max(pixel[c], 0.0f), tone_map);
            bytes.push_back(static_cast<unsigned char>(std::lround(255.0f * srgb_from_linear(shown))));
        }
        bytes.push_back(255);
    }
    write_png(bytes, image.width, image.height, path);
}

void write_png(const std::vector<unsigned char>& rgba, int width, int height,
               const std::filesystem::path& path) {
    if (path.extension() != ".png")
        throw Error(fmt::format(
            "'{}' is not a kind of picture that can be written; give a name that ends in .png or .exr.",
            path.string()));
    write_pixels(path, width, height, PictureNumbers::bytes, rgba.data());
}

}  // namespace momentscope
