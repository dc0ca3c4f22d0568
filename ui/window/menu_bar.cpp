#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "ui/commands/commands.hpp"
#include "ui/window/parts.hpp"

namespace momentscope::ui {

namespace {

// Lessons that the user opened. The others have commands.
void draw_opened_lessons(const Ui& ui, Workspace& w) {
    for (const Lesson& lesson : w.course.lessons()) {
        if (std::ranges::find(own_lessons(), lesson.id, &Lesson::id) != own_lessons().end()) continue;
        if (ImGui::MenuItem(lesson.title.c_str(), "", w.state.card == lesson.id))
            open_lesson(w.state, lesson);
        ui.record_widget_rect(fmt::format("try.{}", lesson.id));
    }
}

void draw_menus(const Ui& ui, Workspace& w) {
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
        if (menu.id == std::string_view("try")) draw_opened_lessons(ui, w);
        ImGui::EndMenu();
    }
}

}  // namespace

void draw_menu_bar(const Ui& ui, Workspace& w) {
    if (!ImGui::BeginMenuBar()) return;
    if (!is_narrow()) {
        draw_menus(ui, w);
    } else {
        const bool open = ImGui::BeginMenu("Menu");
        ui.record_widget_rect("menu");
        if (open) {
            draw_menus(ui, w);
            ImGui::EndMenu();
        }
    }
    ImGui::EndMenuBar();
}

}  // namespace momentscope::ui
