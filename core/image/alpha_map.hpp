// alpha_map.hpp -- a map of opacities that vary over a surface.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace momentscope {

/// Opacities from 0 to 255, row by row from the lower left corner, like texture coordinates.
struct AlphaMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;  // width * height
};

constexpr int MAX_ALPHA_MAP_SIDE = 8192;

/// The alpha channel of a picture in any format that OpenImageIO reads; if it has none, its first channel.
/// Throws Error, which names the file, if it cannot be read.
AlphaMap read_alpha_map(const std::filesystem::path& path);

}  // namespace momentscope
