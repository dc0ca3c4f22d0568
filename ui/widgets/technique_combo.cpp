#include "ui/widgets/technique_combo.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/techniques/moment_kernel.hpp"

namespace momentscope::ui {

namespace {

// The columns behind the name, in font heights from the left.
constexpr float BITS_AT = 24, PASSES_AT = 29, ORDER_AT = 34.5f, WIDTH = 41.5f;

/// The groups of the list. A technique belongs to the first that holds it.
struct Group {
    const char* name;
    bool (*holds)(const Technique& technique);
};
bool has_moments_in(const Technique& technique, BasisFamily family) {
    return technique.is_of(family) && technique.moment_kernel().bits == 32;
}
constexpr Group GROUPS[] = {
    {"ground truth", [](const Technique& t) { return t.is_truth(); }},
    {"others, without moments of this kind", [](const Technique& t) { return !t.has_moments(); }},
    {"certain and sharp: what else is known",
     [](const Technique& t) { return t.moments().estimation.has_value(); }},
    {"power moments", [](const Technique& t) { return has_moments_in(t, BasisFamily::power); }},
    {"trigonometric moments",
     [](const Technique& t) { return has_moments_in(t, BasisFamily::trigonometric); }},
    {"Chebyshev moments", [](const Technique& t) { return has_moments_in(t, BasisFamily::chebyshev); }},
    {"moments in 16 bits", [](const Technique&) { return true; }}};
constexpr std::size_t SHOWN_ORDER[] = {3, 4, 5, 2, 6, 1, 0};

const Group& group_of(const Technique& technique) {
    return *std::ranges::find_if(GROUPS, [&](const Group& group) { return group.holds(technique); });
}

std::string bits_column(const Technique& row) {
    const int bits = stored_bits(row, {});
    if (bits > 0) return fmt::format("{} bits", bits);
    return row.is_truth() ? "no limit" : "0 bits";
}

std::string passes_column(const Technique& row) {
    if (row.geometry_passes == 0) return "all layers";
    return row.geometry_passes == 1 ? "1 pass" : fmt::format("{} passes", row.geometry_passes);
}

void at_column(float place, const std::string& text) {
    ImGui::SameLine(place * em());
    ImGui::TextDisabled("%s", text.c_str());
}

void draw_entry(const Ui& ui, const std::string& anchor, const Technique& row, const Technique*& chosen) {
    const std::string why_not = why_unavailable(row, ui.gl);
    ImGui::BeginDisabled(!why_not.empty());
    if (ImGui::Selectable(technique_label(row).c_str(), &row == chosen)) chosen = &row;
    ui.record_widget_rect(fmt::format("{}.{}", anchor, row.id));
    tooltip(why_not.empty() ? row.description : fmt::format("Not available here. {}", why_not), row.source);
    at_column(BITS_AT, bits_column(row));
    at_column(PASSES_AT, passes_column(row));
    at_column(ORDER_AT, row.order_dependent ? "order matters" : "any order");
    ImGui::EndDisabled();
}

}  // namespace

std::string technique_label(const Technique& row) {
    return fmt::format("{} ({})", row.name, row.id);
}

void draw_technique_combo(const Ui& ui, const std::string& anchor, const std::string& help,
                          const std::string& source, const Technique*& chosen) {
    ImGui::SetNextWindowSizeConstraints({WIDTH * em(), 0}, {WIDTH * em(), 1e6f});
    const bool open = ImGui::BeginCombo(("##" + anchor).c_str(), technique_label(*chosen).c_str(),
                                        ImGuiComboFlags_HeightLargest | ImGuiComboFlags_PopupAlignLeft);
    ui.record_widget_rect(anchor);
    tooltip(help, source);
    if (!open) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.1f * em()});
    for (const std::size_t index : SHOWN_ORDER) {
        ImGui::PushFont(bold_font());
        ImGui::TextDisabled("%s", GROUPS[index].name);
        ImGui::PopFont();
        for (const Technique& row : techniques())
            if (&group_of(row) == &GROUPS[index]) draw_entry(ui, anchor, row, chosen);
    }
    ImGui::PopStyleVar();
    ImGui::EndCombo();
}

}  // namespace momentscope::ui
