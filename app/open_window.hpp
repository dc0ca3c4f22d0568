// open_window.hpp -- the window on a display.
#pragma once
#include <string>

#include "app/options.hpp"
#include "ui/window/explorer.hpp"

namespace momentscope {

/// The start values of a window.
struct WindowStart {
    ui::ExplorerState state;
    ui::Course course;
    std::string problem;  // said in the status line; "": none
    glm::ivec2 size;
    float scale;
    PixelOption pixel;
    std::string log;
};

/// Opens the window and draws whenever something changes, until the user closes it. Throws Error if there is
/// no display, or if the first scene cannot be shown.
void run_window(const WindowStart& start);

/// Picks the pixel of --pixel, which refers to the scene's picture. Call it when the picture is there.
void pick_option(const PixelOption& pixel, ui::Explorer& explorer);

}  // namespace momentscope
