// rich_text.hpp -- text with bold parts and with terms of the glossary, which explain themselves under the
// mouse.
#pragma once
#include <string>

#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws a text with marks (ui/model/glossary.hpp) in lines of this width in pixels.
void draw_rich_text(const Ui& ui, const std::string& text, float width);

/// The height in pixels that draw_rich_text takes.
float rich_text_height(const std::string& text, float width);

}  // namespace momentscope::ui
