// figure_picture.hpp -- a figure's panels side by side as one .png.
#pragma once
#include <filesystem>

#include "app/gui_session.hpp"
#include "core/figures/figure.hpp"

namespace momentscope {

/// The greatest picture that is drawn; the GL's default framebuffer must be as large.
constexpr glm::ivec2 MAX_FIGURE_SIZE(1800, 1400);
constexpr float FIGURE_SCALE = 1.0f;  // of fonts

/// Draws with the window's own plot and fonts. Throws Error.
void write_figure_picture(GuiSession& gui, const Figure& figure, RenderSource& setups,
                          const std::filesystem::path& path);

}  // namespace momentscope
