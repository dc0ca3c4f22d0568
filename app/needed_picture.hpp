// needed_picture.hpp -- the moments that pixels need, as maps with a legend and their histogram.
#pragma once
#include <filesystem>
#include <span>

#include "core/image/image.hpp"
#include "core/inspect/moments_needed.hpp"

namespace momentscope {

/// Writes a .png: what the certificate asks for, what the measured error asks for, and where they disagree,
/// beside the picture itself. Pixels are row by row from the upper left, as many as the picture has. Needs no
/// current GL context.
void write_needed_picture(const Image& picture, std::span<const PixelNeed> pixels, const std::string& title,
                          const std::filesystem::path& path);

}  // namespace momentscope
