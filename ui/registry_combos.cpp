#include "ui/registry_combos.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include "core/scene/scenes.hpp"

namespace momentscope::ui {

bool draw_technique_combo(const Technique*& technique) {
    const auto label = [](const Technique& row) { return fmt::format("{} ({})", row.name, row.id); };
    if (!ImGui::BeginCombo("##technique", label(*technique).c_str())) return false;
    bool changed = false;
    for (const Technique& row : techniques()) {
        if (ImGui::Selectable(label(row).c_str(), &row == technique)) {
            technique = &row;
            changed = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", row.description, row.source);
    }
    ImGui::EndCombo();
    return changed;
}

bool draw_scene_combo(std::string& scene) {
    if (!ImGui::BeginCombo("##scene", scene.c_str())) return false;
    bool changed = false;
    for (const SceneEntry& entry : scene_entries()) {
        if (ImGui::Selectable(entry.id, scene == entry.id)) {
            scene = entry.id;
            changed = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.description);
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace momentscope::ui
