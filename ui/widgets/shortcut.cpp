#include "ui/widgets/shortcut.hpp"

#include <imgui.h>

#include <cctype>
#include <iterator>

namespace momentscope::ui {

namespace {

struct NamedKey {
    const char* name;
    int number;  // GLFW's number
    int imgui;   // ImGuiKey_ value, or -1
};
constexpr NamedKey KEYS[] = {{"Space", 32, ImGuiKey_Space},
                             {"Escape", 256, ImGuiKey_Escape},
                             {"Enter", 257, ImGuiKey_Enter},
                             {"Tab", 258, ImGuiKey_Tab},
                             {"Backspace", 259, ImGuiKey_Backspace},
                             {"Insert", 260, ImGuiKey_Insert},
                             {"Delete", 261, ImGuiKey_Delete},
                             {"Right", 262, ImGuiKey_RightArrow},
                             {"Left", 263, ImGuiKey_LeftArrow},
                             {"Down", 264, ImGuiKey_DownArrow},
                             {"Up", 265, ImGuiKey_UpArrow},
                             {"PageUp", 266, ImGuiKey_PageUp},
                             {"PageDown", 267, ImGuiKey_PageDown},
                             {"Home", 268, ImGuiKey_Home},
                             {"End", 269, ImGuiKey_End},
                             {"Plus", 61, -1},  // the key of = on an American keyboard
                             {"Minus", 45, -1},
                             {"F1", 290, -1},
                             {"F9", 298, -1},
                             {"F11", 300, -1}};

bool modifiers_match(const Shortcut& shortcut) {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeyCtrl == shortcut.ctrl && io.KeyShift == shortcut.shift && !io.KeyAlt && !io.KeySuper;
}

}  // namespace

std::optional<Shortcut> parse_shortcut(std::string_view name) {
    Shortcut shortcut;
    for (bool found = true; found;) {
        found = false;
        for (const auto& [prefix, flag] :
             {std::pair("Ctrl+", &shortcut.ctrl), std::pair("Shift+", &shortcut.shift)})
            if (name.starts_with(prefix)) {
                name.remove_prefix(std::string_view(prefix).size());
                *flag = found = true;
            }
    }
    for (const NamedKey& key : KEYS)
        if (name == key.name) shortcut.key = key.number;
    if (shortcut.key != 0) return shortcut;
    if (name.size() != 1) return std::nullopt;
    if (std::isalnum(static_cast<unsigned char>(name[0])) != 0)
        shortcut.key = std::toupper(static_cast<unsigned char>(name[0]));
    else
        shortcut.character = name[0];
    return shortcut;
}

bool pressed(const Shortcut& shortcut, bool repeats) {
    const ImGuiIO& io = ImGui::GetIO();
    constexpr int ESCAPE = 256;
    if (io.WantTextInput && !shortcut.ctrl && shortcut.key != ESCAPE) return false;
    if (shortcut.character != 0) {
        for (const ImWchar typed : io.InputQueueCharacters)
            if (typed == static_cast<unsigned char>(shortcut.character)) return true;
        return false;
    }
    return modifiers_match(shortcut) && ImGui::IsKeyPressed(shortcut.key, repeats);
}

bool held(const Shortcut& shortcut) {
    return !ImGui::GetIO().WantTextInput && modifiers_match(shortcut) && ImGui::IsKeyDown(shortcut.key);
}

void use_key_numbers() {
    ImGuiIO& io = ImGui::GetIO();
    for (const NamedKey& key : KEYS)
        if (key.imgui >= 0) io.KeyMap[key.imgui] = key.number;
    for (const auto& [imgui, letter] :
         {std::pair(ImGuiKey_A, 'A'), std::pair(ImGuiKey_C, 'C'), std::pair(ImGuiKey_V, 'V'),
          std::pair(ImGuiKey_X, 'X'), std::pair(ImGuiKey_Y, 'Y'), std::pair(ImGuiKey_Z, 'Z')})
        io.KeyMap[imgui] = static_cast<unsigned char>(letter);
}

}  // namespace momentscope::ui
