#include "ui/theme.hpp"

#include <filesystem>

#include "core/error.hpp"

namespace momentscope::ui {

void apply_theme(float scale) {
    constexpr const char* FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    static const ImWchar ranges[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2027, 0x2070, 0x209F, 0x2100,
                                     0x214F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};
    if (!std::filesystem::exists(FONT))
        throw Error("The font DejaVu Sans is missing; install the package fonts-dejavu-core.");
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->AddFontFromFileTTF(FONT, 15.0f * scale, nullptr, ranges);
    io.IniFilename = nullptr;  // nothing is written behind the user's back
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.WindowPadding = {10, 8};
    style.ItemSpacing = {8, 6};
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.115f, 0.125f, 0.14f, 1);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.19f, 0.205f, 0.23f, 1);
    style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.34f, 0.71f, 0.91f, 1);
    style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0.55f, 0.82f, 0.97f, 1);
    style.ScaleAllSizes(scale);
}

}  // namespace momentscope::ui
