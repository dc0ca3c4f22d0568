// ui.hpp -- what every panel draws with: colours, sizes, and the places of its controls.
#pragma once
#include <imgui.h>

#include <glm/glm.hpp>
#include <map>
#include <string>

#include "ui/theme.hpp"

namespace momentscope::ui {

struct Rect {
    ImVec2 low, high;
    bool empty() const { return !(low.x < high.x && low.y < high.y); }
};

/// Where named controls were drawn in the last frame, so that event files and tests can point at them without
/// knowing the layout.
using WidgetRects = std::map<std::string, Rect>;

struct Ui {
    const Palette& colors;
    WidgetRects& widget_rects;

    /// Names the control that was drawn last.
    void record_widget_rect(const std::string& name) const {
        widget_rects[name] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    }
};

/// One font height, by which all sizes are measured.
inline float em() {
    return ImGui::GetFontSize();
}

/// A text before a control, which begins `width` font heights from the left.
void label(const char* text, float width = 6.5f);

/// A wrapped tooltip for the control that was drawn last: what it is, and in weaker text its shortcut or
/// source.
void tooltip(const std::string& text, const std::string& weaker = "");

/// A colour of [0, 1], as draw lists take it.
ImU32 packed(const glm::vec3& color);

/// A linear colour as the display shows it.
ImVec4 display_color(const glm::vec3& linear);

/// Puts the next control of that width beside the last one, or into a new line where it would pass `right` (a
/// screen coordinate).
void flow(float width, float right, float gap);

/// How wide a button with that label is.
float button_width(const char* label);

/// A button that looks pressed while `on`. True when it was clicked.
bool toggle_button(const char* label, bool on);

}  // namespace momentscope::ui
