#include "core/image/alpha_map.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/error.hpp"

namespace momentscope {

AlphaMap read_alpha_map(const std::filesystem::path& path) {
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        throw Error(fmt::format("The opacity texture '{}' does not exist.", path.string()));
    const auto fail = [&](std::string reason) {
        reason.resize(std::min(reason.find('\n'), reason.size()));
        throw Error(fmt::format("The opacity texture '{}' cannot be read ({}).", path.string(),
                                reason.empty() ? "no reason given" : reason));
    };
    const auto file = OIIO::ImageInput::open(path.string());
    if (!file) fail(OIIO::geterror());
    const OIIO::ImageSpec& spec = file->spec();
    if (std::min(spec.width, spec.height) < 1 || std::max(spec.width, spec.height) > MAX_ALPHA_MAP_SIDE ||
        spec.depth > 1 || spec.nchannels < 1)
        throw Error(fmt::format("The opacity texture '{}' has {}x{} pixels; from 1x1 to {}x{} are read.",
                                path.string(), spec.width, spec.height, MAX_ALPHA_MAP_SIDE,
                                MAX_ALPHA_MAP_SIDE));
    AlphaMap map{spec.width, spec.height, {}};
    const auto width = static_cast<std::size_t>(map.width);
    const auto height = static_cast<std::size_t>(map.height);
    map.bytes.resize(width * height);
    const int channel = std::max(spec.alpha_channel, 0);
    if (!file->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::UINT8, map.bytes.data()))
        fail(file->geterror());
    for (std::size_t y = 0; y < height / 2; ++y)
        std::swap_ranges(map.bytes.begin() + static_cast<std::ptrdiff_t>(y * width),
                         map.bytes.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                         map.bytes.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * width));
    return map;
}

}  // namespace momentscope
