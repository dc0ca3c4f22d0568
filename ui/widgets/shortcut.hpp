// shortcut.hpp -- keys by name: "Ctrl+Shift+P", "F1", "Left", "?".
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace momentscope::ui {

/// A key with the number that ImGui uses here, which is GLFW's: letters and digits have their ASCII code.
struct Shortcut {
    int key = 0;         // 0: the shortcut is a typed character
    char character = 0;  // for characters whose key differs between keyboards, such as '?'
    bool ctrl = false;
    bool shift = false;
    friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

/// nullopt if the name is not that of a key.
std::optional<Shortcut> parse_shortcut(std::string_view name);

/// Was it pressed in this frame? False while text is being typed, unless the shortcut has Ctrl or is Escape.
/// `repeats`: does a held key count again and again?
bool pressed(const Shortcut& shortcut, bool repeats = false);

/// Is the key held down, with exactly the modifiers of the shortcut?
bool held(const Shortcut& shortcut);

/// Makes ImGui use GLFW's key numbers, for contexts without a window.
void use_key_numbers();

}  // namespace momentscope::ui
