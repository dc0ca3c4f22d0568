// shortcut.hpp -- keys by name: "Ctrl+Shift+P", "F1", "Left", "?".
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace momentscope::ui {

/// A key as ImGui numbers it here, which is as GLFW does: letters and digits by their ASCII code.
struct Shortcut {
    int key = 0;         // 0: none, but a typed character
    char character = 0;  // for keys whose place differs between keyboards, as '?'
    bool ctrl = false;
    bool shift = false;
    friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

/// nullopt for a name that is none.
std::optional<Shortcut> parse_shortcut(std::string_view name);

/// Was it pressed in this frame? False while a text is being typed, unless it has Ctrl or is Escape.
/// `repeats`: does a key that is held count again and again?
bool pressed(const Shortcut& shortcut, bool repeats = false);

/// Is its key down, without modifiers?
bool held(const Shortcut& shortcut);

/// Tells ImGui GLFW's key numbers, for contexts without a window.
void use_key_numbers();

}  // namespace momentscope::ui
