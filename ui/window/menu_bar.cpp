#include <fmt/format.h>

#include "ui/commands/commands.hpp"
#include "ui/window/parts.hpp"

namespace momentscope::ui {

void draw_menu_bar(const Ui& ui, Workspace& w) {
    if (!ImGui::BeginMenuBar()) return;
    for (const Menu& menu : menus()) {
        const bool open = ImGui::BeginMenu(menu.title);
        ui.record_widget_rect(fmt::format("menu.{}", menu.id));
        if (!open) continue;
        for (const Command& command : commands()) {
            if (!command.id.starts_with(std::string(menu.id) + ".")) continue;
            const std::string key =
                command.keys.empty() ? "" : command.keys.front() + (command.run ? "" : " (hold)");
            const bool checked = command.checked && command.checked(w);
            if (ImGui::MenuItem(command.name.c_str(), key.c_str(), checked,
                                command.run && is_enabled(command, w)))
                command.run(w);
            ui.record_widget_rect(command.id);
            tooltip(command.help);
        }
        ImGui::EndMenu();
    }
    ImGui::EndMenuBar();
}

}  // namespace momentscope::ui
