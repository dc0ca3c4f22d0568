#include "ui/widgets/technique_combo.hpp"

#include <fmt/format.h>

namespace momentscope::ui {

std::string technique_label(const Technique& row) {
    return fmt::format("{} ({})", row.name, row.id);
}

void draw_technique_combo(const Ui& ui, const std::string& anchor, const std::string& help,
                          const std::string& source, const Technique*& chosen) {
    const bool open = ImGui::BeginCombo(("##" + anchor).c_str(), technique_label(*chosen).c_str(),
                                        ImGuiComboFlags_HeightLargest);
    ui.record_widget_rect(anchor);
    tooltip(help, source);
    if (!open) return;
    for (const Technique& row : techniques()) {
        const std::string why_not = why_unavailable(row, ui.gl);
        ImGui::BeginDisabled(!why_not.empty());
        if (ImGui::Selectable(technique_label(row).c_str(), &row == chosen)) chosen = &row;
        ImGui::EndDisabled();
        ui.record_widget_rect(fmt::format("{}.{}", anchor, row.id));
        tooltip(why_not.empty() ? row.description : fmt::format("Not available here. {}", why_not),
                row.source);
    }
    ImGui::EndCombo();
}

}  // namespace momentscope::ui
