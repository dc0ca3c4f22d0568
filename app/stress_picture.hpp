// stress_picture.hpp -- draws the heat map of a stress run into a .png.
#pragma once
#include <filesystem>

#include "core/stress/stress.hpp"

namespace momentscope {

/// Draws the same map as the window, without a display. Throws Error.
void write_stress_picture(const std::vector<StressCell>& cells, const StressOptions& options,
                          const std::filesystem::path& path);

}  // namespace momentscope
