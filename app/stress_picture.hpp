// stress_picture.hpp -- the heat map of a stress run as a .png.
#pragma once
#include <filesystem>

#include "core/stress/stress.hpp"

namespace momentscope {

/// Draws the window's own map without a display. Throws Error.
void write_stress_picture(const std::vector<StressCell>& cells, const StressOptions& options,
                          const std::filesystem::path& path);

}  // namespace momentscope
