// alpha_map.hpp -- opacity that varies over a surface.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace momentscope {

/// Opacities from 0 to 255, row by row from the lower left corner, as texture coordinates count.
struct AlphaMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;  // width * height
};

constexpr int MAX_ALPHA_MAP_SIDE = 8192;

/// The alpha channel of any picture that OpenImageIO knows; of a picture without one its first channel.
/// Throws Error that names the file.
AlphaMap read_alpha_map(const std::filesystem::path& path);

}  // namespace momentscope
