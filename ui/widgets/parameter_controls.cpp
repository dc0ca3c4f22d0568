#include "ui/widgets/parameter_controls.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/render/transparency.hpp"
#include "core/support/error.hpp"

namespace momentscope::ui {

namespace {

constexpr float MIN_EXPONENT = -9;  // logarithmic sliders start at 10^-9; the left end is 0

std::string shown_name(const Parameter& row) {
    return fmt::format("{} {}", row.name, row.symbol);  // with the name, because alpha alone is ambiguous
}

// ImGui's own logarithmic sliders do not reach this far down, so this slider sets the exponent.
bool draw_logarithmic(const Parameter& row, float& value) {
    const float most = std::log10(row.maximum);
    const float first = row.minimum > 0 ? std::log10(row.minimum) : MIN_EXPONENT;
    const float least = row.minimum > 0 ? first : MIN_EXPONENT - 0.25f;
    float exponent = value > 0 ? std::clamp(std::log10(value), first, most) : least;
    const bool plain = row.maximum > 1;  // a length instead of a small share
    const std::string shown = plain       ? fmt::format("{:.4g}", static_cast<double>(value))
                              : value > 0 ? fmt::format("{:.2e}", static_cast<double>(value))
                                          : "0";
    if (!ImGui::SliderFloat("##value", &exponent, least, most, shown.c_str(), ImGuiSliderFlags_NoInput))
        return false;
    value = exponent < first ? row.minimum : std::clamp(std::pow(10.0f, exponent), row.minimum, row.maximum);
    return true;
}

bool draw_choice(const Ui& ui, const Parameter& row, const Technique& technique,
                 const ParameterValues& values, float& value) {
    const auto chosen = static_cast<std::size_t>(value);
    bool changed = false;
    if (!ImGui::BeginCombo("##value", row.choices[chosen])) return false;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        ParameterValues then = values;
        then.set(row.id, static_cast<float>(i));
        const char* refused = why_refused(technique, then);
        const std::string why_not = refused != nullptr ? refused : why_unavailable({&technique, then}, ui.gl);
        ImGui::BeginDisabled(!why_not.empty());
        const bool clicked = ImGui::Selectable(row.choices[i], i == chosen);
        ImGui::EndDisabled();
        ui.record_widget_rect(fmt::format("parameter.{}.{}", row.key, row.choices[i]));
        if (!why_not.empty()) tooltip(why_not);
        if (!clicked || i == chosen) continue;
        value = static_cast<float>(i);
        changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

bool draw_value(const Ui& ui, const Parameter& row, const Technique& technique, const ParameterValues& values,
                float& value) {
    switch (row.scale) {
        case Scale::logarithmic:
            return draw_logarithmic(row, value);
        case Scale::toggle: {
            bool on = value != 0;
            const bool changed = ImGui::Checkbox("##value", &on);
            value = on ? 1.0f : 0.0f;
            return changed;
        }
        case Scale::choice:
            return draw_choice(ui, row, technique, values, value);
        case Scale::whole: {
            int number = static_cast<int>(value);
            const bool wide = row.maximum > 1000 * std::max(row.minimum, 1.0f);
            const bool changed = ImGui::SliderInt(
                "##value", &number, static_cast<int>(row.minimum), static_cast<int>(row.maximum), "%d",
                ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput |
                    (wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None));
            value = static_cast<float>(number);
            return changed;
        }
        case Scale::linear:
            break;
    }
    const std::string format = *row.unit != '\0' ? fmt::format("%.3f {}", row.unit) : "%.3f";
    // Rounding to the shown digits would leave the range: pi is less than 3.142.
    return ImGui::SliderFloat(
        "##value", &value, row.minimum, row.maximum, format.c_str(),
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
}

// Ctrl+click on the slider replaces it by a text field. The typed text is parsed like an option of the
// command line, with the same checks and messages.
enum Typing { not_typing, begin_typing, typing };

int& typing_state() {
    return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("typing"), not_typing);
}

void draw_typed(const Parameter& row, ParameterValues& values, Status& status) {
    int& state = typing_state();
    if (state == begin_typing) ImGui::SetKeyboardFocusHere();
    std::string typed;  // ImGui keeps the typed text until Enter
    const bool entered =
        ImGui::InputTextWithHint("##typed", row.default_value ? "a number" : "a number, or auto", &typed,
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    if (entered && !typed.empty()) {
        try {
            values.set(row.id, parse_parameter(row, typed));
        } catch (const Error& error) {
            status.say(error.what());
        }
    }
    // A popup that is just closing may take back the keyboard; then request it again.
    if (ImGui::IsItemActive())
        state = typing;
    else if (entered || (state == typing && ImGui::IsItemDeactivated()))
        state = not_typing;
}

bool is_slider(const Parameter& row) {
    return row.scale == Scale::linear || row.scale == Scale::logarithmic || row.scale == Scale::whole;
}

void draw_tooltip(const Parameter& row) {
    tooltip(parameter_help(row),
            is_slider(row) ? "Ctrl+click to type a value, double-click to reset it." : "");
}

bool double_clicked() {
    return ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

}  // namespace

std::string parameter_help(const Parameter& row) {
    const std::string unit = row.default_value && *row.unit != '\0' ? fmt::format(" {}", row.unit) : "";
    return fmt::format("{}. {}\n--{}, {}; default {}{}. Source: {}.", shown_name(row), row.help, row.key,
                       parameter_values_text(row), parameter_text(row, row.default_value), unit, row.source);
}

void draw_parameter_control(const Ui& ui, const Parameter& row, const Technique& technique, float label_width,
                            bool type_now, ParameterValues& values, Status& status,
                            std::optional<float> automatic) {
    ImGui::PushID(row.key);
    const float recommended = automatic.value_or(automatic_bias(values, technique));
    float value = values[row.id].value_or(recommended);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown_name(row).c_str());
    draw_tooltip(row);
    bool reset = double_clicked();
    ImGui::SameLine(label_width);
    ImGui::SetNextItemWidth(row.default_value ? -1.0f : -4.3f * em());
    if (type_now) typing_state() = begin_typing;
    if (typing_state() != not_typing) {
        draw_typed(row, values, status);
    } else {
        const bool to_type = ImGui::GetIO().KeyCtrl && is_slider(row);
        if (draw_value(ui, row, technique, values, value) && !to_type) values.set(row.id, value);
        reset |= is_slider(row) && double_clicked();
        if (to_type && ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left))
            typing_state() = begin_typing;
    }
    ui.record_widget_rect(fmt::format("parameter.{}", row.key));
    draw_tooltip(row);
    if (reset) {
        values.set(row.id, row.default_value);
        ImGui::ClearActiveID();  // the button is still down; otherwise the slider would follow it again
    }
    if (!row.default_value) {
        ImGui::SameLine();
        bool on = !values[row.id].has_value();
        if (ImGui::Checkbox("auto", &on)) values.set(row.id, on ? std::nullopt : std::optional(value));
        ui.record_widget_rect(fmt::format("parameter.{}.auto", row.key));
        tooltip(automatic
                    ? fmt::format("Takes the scene's own value, {:.3g}.", static_cast<double>(recommended))
                    : fmt::format("Takes the bias preset's value for this technique, {:.1e}.",
                                  static_cast<double>(recommended)));
    }
    ImGui::PopID();
}

}  // namespace momentscope::ui
