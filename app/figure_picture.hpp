// figure_picture.hpp -- draws the panels of a figure side by side into a .png.
#pragma once
#include <filesystem>

#include "app/gui_session.hpp"
#include "core/figures/figure.hpp"

namespace momentscope {

/// The greatest size of a figure; the default framebuffer of the GL must be as large.
constexpr glm::ivec2 MAX_FIGURE_SIZE(1800, 1400);
constexpr float FIGURE_SCALE = 1.0f;  // of fonts

/// Draws with the plot and the fonts of the window. Throws Error.
void write_figure_picture(GuiSession& gui, const Figure& figure, RenderSource& setups,
                          const std::filesystem::path& path);

}  // namespace momentscope
