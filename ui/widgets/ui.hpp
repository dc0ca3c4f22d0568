// ui.hpp -- common tools of all panels: colours, sizes, and the places of controls.
#pragma once
#include <imgui.h>

#include <glm/glm.hpp>
#include <map>
#include <string>

#include "core/gl/capabilities.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope::ui {

struct Rect {
    ImVec2 low, high;
    bool empty() const { return !(low.x < high.x && low.y < high.y); }
};

/// The places of named controls in the last frame, so that event files and tests can point at them without
/// knowledge of the layout.
using WidgetRects = std::map<std::string, Rect>;

struct Ui {
    const Palette& colors;
    WidgetRects& widget_rects;
    Capabilities gl = {};  // controls of what it cannot draw are greyed out

    /// Records the place of the last drawn control under a name.
    void record_widget_rect(const std::string& name) const {
        widget_rects[name] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    }
};

/// One font height; all sizes are multiples of it.
inline float em() {
    return ImGui::GetFontSize();
}

/// Draws a text before a control. The control begins `width` font heights from the left.
void label(const char* text, float width = 6.5f);

/// A wrapped tooltip for the last drawn control: its meaning, and in weaker text its shortcut or source.
void tooltip(const std::string& text, const std::string& weaker = "");

/// The beginning of a text that fits into `width` pixels, with "…" if something is missing.
std::string elided(const std::string& text, float width);

/// A GL texture as ImGui hands it on.
ImTextureID texture_id(unsigned name);

/// A colour with channels in [0, 1], packed for draw lists.
ImU32 packed(const glm::vec3& color);

/// A linear colour, converted for the display.
ImVec4 display_color(const glm::vec3& linear);

/// Puts the next control, of this width, beside the last one, or on a new line if it would pass `right` (a
/// screen coordinate).
void flow(float width, float right, float gap);

/// The width of a button with this label.
float button_width(const char* label);

/// A button that looks pressed if `on` is true. Returns true if it was clicked.
bool toggle_button(const char* label, bool on);

}  // namespace momentscope::ui
