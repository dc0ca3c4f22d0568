#include "ui/widgets/ui.hpp"

#include <cstdint>

#include "core/image/image.hpp"

namespace momentscope::ui {

void tooltip(const std::string& text, const std::string& weaker) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28 * em());
    ImGui::TextUnformatted(text.c_str());
    if (!weaker.empty()) ImGui::TextDisabled("%s", weaker.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void label(const char* text, float width) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(width * em());
}

ImTextureID texture_id(unsigned name) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui hands textures on as pointers
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}

ImU32 packed(const glm::vec3& color) {
    return ImGui::ColorConvertFloat4ToU32(ImVec4(color.r, color.g, color.b, 1));
}

ImVec4 display_color(const glm::vec3& linear) {
    return {srgb_from_linear(linear.r), srgb_from_linear(linear.g), srgb_from_linear(linear.b), 1};
}

std::string elided(const std::string& text, float width) {
    const auto fits = [&](const std::string& tried) { return ImGui::CalcTextSize(tried.c_str()).x <= width; };
    if (fits(text)) return text;
    const auto begins_letter = [&](std::size_t at) { return (text[at] & 0xC0) != 0x80; };  // of UTF-8
    std::size_t least = 0;
    std::size_t most = text.size();  // the first length that does not fit lies between these
    while (most - least > 1) {
        const std::size_t middle = least + (most - least) / 2;
        (fits(text.substr(0, middle) + "…") ? least : most) = middle;
    }
    while (least > 0 && !begins_letter(least)) --least;
    return least == 0 ? "" : text.substr(0, least) + "…";
}

void flow(float width, float right, float gap) {
    ImGui::SameLine(0, gap);
    if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
}

float button_width(const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool toggle_button(const char* label, bool on) {
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool clicked = ImGui::Button(label);
    if (on) ImGui::PopStyleColor();
    return clicked;
}

}  // namespace momentscope::ui
