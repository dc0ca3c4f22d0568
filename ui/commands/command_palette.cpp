#include "ui/commands/command_palette.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

namespace {

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string menu_title(const Command& command) {
    for (const Menu& menu : menus())
        if (command.id.starts_with(std::string(menu.id) + ".")) return menu.title;
    return "";
}

void place_window(float width, float height, float top) {
    const ImVec2 room = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowSize(
        {std::min(width * em(), 0.95f * room.x), std::min(height * em(), 0.9f * room.y)});
    ImGui::SetNextWindowPos({0.5f * room.x, top * room.y}, ImGuiCond_Always, {0.5f, top});
}

// Returns true if the entry was clicked.
bool draw_entry(const Ui& ui, const Command& command, bool selected) {
    const std::string label = fmt::format("{}: {}##{}", menu_title(command), command.name, command.id);
    const bool clicked = ImGui::Selectable(label.c_str(), selected);
    ui.record_widget_rect("palette." + command.id);
    tooltip(command.help);
    if (!command.keys.empty()) {
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 9 * em());
        ImGui::TextDisabled("%s", command.keys.front().c_str());
    }
    return clicked;
}

void key_row(const std::string& keys, const std::string& name, const std::string& help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", help.c_str());
    ImGui::PopStyleColor();
}

// Handles typing and moves the selection. Returns true if Enter was pressed.
bool draw_typed(const Ui& ui, PaletteState& palette) {
    ImGui::SetNextItemWidth(-1);
    if (palette.begin) ImGui::SetKeyboardFocusHere();
    palette.begin = false;
    const std::string before = palette.typed;
    const bool accepted = ImGui::InputTextWithHint("##typed", "type what you want to do", &palette.typed,
                                                   ImGuiInputTextFlags_EnterReturnsTrue);
    ui.record_widget_rect("palette.typed");
    if (palette.typed != before) palette.chosen = 0;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++palette.chosen;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) --palette.chosen;
    return accepted;
}

}  // namespace

bool matches(const Command& command, const std::string& typed) {
    const std::string text = lower(menu_title(command) + " " + command.name + " " + command.help);
    std::istringstream words(lower(typed));
    for (std::string word; words >> word;)
        if (text.find(word) == std::string::npos) return false;
    return true;
}

const Command* draw_palette(const Ui& ui, Workspace& workspace) {
    PaletteState& palette = workspace.palette;
    if (!palette.open) return nullptr;
    if (palette.begin) ImGui::OpenPopup("###palette");
    place_window(40, 26, 0.15f);
    palette.open = ImGui::BeginPopup("###palette", ImGuiWindowFlags_NoSavedSettings);
    if (!palette.open) return nullptr;
    const Command* chosen = nullptr;
    const int before = palette.chosen;
    const bool accepted = draw_typed(ui, palette);
    std::vector<const Command*> found;
    for (const Command& command : commands())
        if (command.run && is_enabled(command, workspace) && matches(command, palette.typed))
            found.push_back(&command);
    palette.chosen = std::clamp(palette.chosen, 0, std::max(static_cast<int>(found.size()) - 1, 0));
    ImGui::BeginChild("found");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool selected = static_cast<int>(i) == palette.chosen;
        if (draw_entry(ui, *found[i], selected) || (selected && accepted)) chosen = found[i];
        if (selected && palette.chosen != before) ImGui::SetScrollHereY();
    }
    if (found.empty()) ImGui::TextDisabled("No command contains these words.");
    ImGui::EndChild();
    palette.open = chosen == nullptr;
    if (!palette.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

void draw_help(const Ui& ui, bool& open) {
    if (!open) return;
    place_window(60, 44, 0.5f);
    if (!ImGui::Begin(
            "Keys and mouse###help", &open,
            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
        ImGui::End();
        return;
    }
    ui.widget_rects["help"] = {ImGui::GetWindowPos(),
                               {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                                ImGui::GetWindowPos().y + ImGui::GetWindowHeight()}};
    const auto begin_table = [](const char* id) {
        if (!ImGui::BeginTable(id, 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) return false;
        ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 12 * em());
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 16 * em());
        ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
        return true;
    };
    for (const Menu& menu : menus()) {
        ImGui::PushFont(bold_font());
        ImGui::TextUnformatted(menu.title);
        ImGui::PopFont();
        if (!begin_table(menu.id)) continue;
        for (const Command& command : commands()) {
            if (!command.id.starts_with(std::string(menu.id) + ".") || command.keys.empty()) continue;
            key_row(fmt::format("{}", fmt::join(command.keys, ", ")), command.name, command.help);
        }
        ImGui::EndTable();
    }
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted("Mouse");
    ImGui::PopFont();
    if (begin_table("mouse")) {
        for (const MouseAction& action : mouse_actions()) key_row(action.how, action.where, action.what);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace momentscope::ui
