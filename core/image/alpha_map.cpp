#include "core/image/alpha_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/image/picture_file.hpp"
#include "core/support/error.hpp"

namespace momentscope {

AlphaMap read_alpha_map(const std::filesystem::path& path) {
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        throw Error(fmt::format("The opacity texture '{}' does not exist.", path.string()));
    PictureFile file(path, "opacity texture");
    file.require_size(MAX_ALPHA_MAP_SIDE, std::size_t{MAX_ALPHA_MAP_SIDE} * MAX_ALPHA_MAP_SIDE, 1);
    const PictureHeader& header = file.header();
    AlphaMap map{header.width, header.height, {}};
    const auto width = static_cast<std::size_t>(map.width);
    const auto height = static_cast<std::size_t>(map.height);
    map.bytes.resize(width * height);
    const int channel = std::max(header.alpha_channel, 0);
    file.read(channel, 1, PictureNumbers::bytes, map.bytes.data());
    for (std::size_t y = 0; y < height / 2; ++y)
        std::swap_ranges(map.bytes.begin() + static_cast<std::ptrdiff_t>(y * width),
                         map.bytes.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                         map.bytes.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * width));
    return map;
}

}  // namespace momentscope
