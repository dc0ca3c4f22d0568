// needed_picture.hpp -- draws maps of the moments that pixels need, with legends and histograms.
#pragma once
#include <filesystem>
#include <span>

#include "core/image/image.hpp"
#include "core/inspect/moments_needed.hpp"

namespace momentscope {

/// Writes a .png with the picture and three maps: the moments that the certificate asks for, those that the
/// measured error asks for, and where the two disagree. `pixels` are row by row from the upper left, as many
/// as the picture has. Needs no current GL context.
void write_needed_picture(const Image& picture, std::span<const PixelNeed> pixels, const std::string& title,
                          const std::filesystem::path& path);

}  // namespace momentscope
