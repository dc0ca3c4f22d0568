#include "ui/parameter_controls.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace momentscope::ui {

namespace {

constexpr float LEAST_EXPONENT = -9;  // sliders of logarithmic parameters start at 10^-9

void draw_tooltip(const Parameter& row) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
    const std::string range = fmt::format("--{}, from {:g} to {:g}{}{}", row.key, row.minimum, row.maximum,
                                          *row.unit != '\0' ? " " : "", row.unit);
    ImGui::Text("%s  %s", row.symbol, row.name);
    ImGui::TextUnformatted(row.help);
    ImGui::TextDisabled("%s\n%s", range.c_str(), row.source);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// ImGui's own logarithmic sliders do not reach this far down, so the slider moves the exponent.
bool draw_logarithmic(const Parameter& row, float& value) {
    const float most = std::log10(row.maximum);
    float exponent = std::clamp(value > 0 ? std::log10(value) : LEAST_EXPONENT, LEAST_EXPONENT, most);
    const std::string shown = fmt::format("{:.2e}", static_cast<double>(value));
    if (!ImGui::SliderFloat("##value", &exponent, LEAST_EXPONENT, most, shown.c_str(),
                            ImGuiSliderFlags_NoInput))
        return false;
    value = std::clamp(std::pow(10.0f, exponent), row.minimum, row.maximum);
    return true;
}

bool draw_value(const Parameter& row, float& value) {
    switch (row.scale) {
        case Scale::logarithmic:
            return draw_logarithmic(row, value);
        case Scale::toggle: {
            bool on = value >= 0.5f;
            const bool changed = ImGui::Checkbox("##value", &on);
            value = on ? 1.0f : 0.0f;
            return changed;
        }
        case Scale::linear:
            break;
    }
    return ImGui::SliderFloat("##value", &value, row.minimum, row.maximum, "%.3f",
                              ImGuiSliderFlags_AlwaysClamp);
}

}  // namespace

bool draw_parameter_control(const Parameter& row, float recommended, ParameterValues& values) {
    ImGui::PushID(row.key);
    const bool automatic = !values[row.id].has_value();
    float value = values[row.id].value_or(recommended);
    bool changed = false;
    const float label_width = 14.5f * ImGui::GetFontSize();
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s %s", row.name, row.symbol);
    draw_tooltip(row);
    ImGui::SameLine(label_width);
    ImGui::SetNextItemWidth(row.standard ? -1.0f : -4.5f * ImGui::GetFontSize());
    if (draw_value(row, value)) {
        values.set(row.id, value);
        changed = true;
    }
    draw_tooltip(row);
    if (!row.standard) {
        ImGui::SameLine();
        bool on = automatic && !changed;
        if (ImGui::Checkbox("auto", &on)) {
            values.set(row.id, on ? std::nullopt : std::optional(value));
            changed = true;
        }
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("the technique's own recommendation, %.1e", static_cast<double>(recommended));
    }
    ImGui::PopID();
    return changed;
}

bool draw_parameter_controls(const Technique& technique, ParameterValues& values) {
    bool changed = false;
    for (const ParameterId id : technique.parameters)
        changed |= draw_parameter_control(parameter(id), technique.recommended_bias, values);
    return changed;
}

}  // namespace momentscope::ui
