#include "ui/widgets/theme.hpp"

#include <filesystem>

#include "core/support/error.hpp"

namespace momentscope::ui {

namespace {

constexpr ImU32 rgb(unsigned hex, unsigned opacity = 255) {
    return IM_COL32((hex >> 16) & 0xFF, (hex >> 8) & 0xFF, hex & 0xFF, opacity);
}

// Okabe and Ito's palette.
constexpr unsigned ORANGE = 0xE69F00, SKY_BLUE = 0x56B4E9, GREEN = 0x009E73, YELLOW = 0xF0E442,
                   BLUE = 0x0072B2, VERMILION = 0xD55E00, PURPLE = 0xCC79A7;

constexpr Palette DARK = {.text = rgb(0xD5D9DE),
                          .warning = rgb(0xF2A33A),
                          .plot_background = rgb(0x15171B),
                          .grid = rgb(0xFFFFFF, 24),
                          .axis = rgb(0xFFFFFF, 90),
                          .truth = rgb(0xF2F2F2),
                          .reconstruction = rgb(ORANGE),
                          .bounds = rgb(SKY_BLUE),
                          .band = rgb(SKY_BLUE, 44),
                          .sharp = rgb(0xA9B8FF),
                          .unbiased_exact = rgb(0x35C79A),
                          .stems = rgb(YELLOW),
                          .errors = rgb(0xF07030),
                          .wrapping_zone = rgb(PURPLE),
                          .wrapping_zone_fill = rgb(PURPLE, 58),
                          .exit = rgb(0xF07030),
                          .compared = {rgb(PURPLE), rgb(SKY_BLUE), rgb(YELLOW), rgb(0x35C79A)},
                          .mark = rgb(0xFFFFFF),
                          .mark_edge = rgb(0x000000),
                          .pin = rgb(YELLOW)};

constexpr Palette LIGHT = {.text = rgb(0x22272E),
                           .warning = rgb(0xA84B00),
                           .plot_background = rgb(0xFFFFFF),
                           .grid = rgb(0x000000, 24),
                           .axis = rgb(0x000000, 110),
                           .truth = rgb(0x16181C),
                           .reconstruction = rgb(VERMILION),
                           .bounds = rgb(BLUE),
                           .band = rgb(SKY_BLUE, 70),
                           .sharp = rgb(0x4338A8),
                           .unbiased_exact = rgb(GREEN),
                           .stems = rgb(0x8A6D00),
                           .errors = rgb(0xB0305A),
                           .wrapping_zone = rgb(0xA84C80),
                           .wrapping_zone_fill = rgb(PURPLE, 70),
                           .exit = rgb(0xB0305A),
                           .compared = {rgb(0xA84C80), rgb(BLUE), rgb(0x8A6D00), rgb(GREEN)},
                           .mark = rgb(0xFFFFFF),
                           .mark_edge = rgb(0x000000),
                           .pin = rgb(YELLOW)};

ImVec4 color(unsigned hex, float opacity = 1) {
    return ImVec4(static_cast<float>((hex >> 16) & 0xFF) / 255, static_cast<float>((hex >> 8) & 0xFF) / 255,
                  static_cast<float>(hex & 0xFF) / 255, opacity);
}

struct WindowColors {
    unsigned window, popup, frame, frame_hovered, frame_active, button, header, accent, border, text, dim;
};
constexpr WindowColors DARK_WINDOW = {0x1D2025, 0x24282E, 0x30353D, 0x3B424C, 0x475060, 0x3A4350,
                                      0x34485A, 0x56B4E9, 0x3A4048, 0xDFE3E8, 0x8F98A3};
constexpr WindowColors LIGHT_WINDOW = {0xF1F3F5, 0xFFFFFF, 0xFFFFFF, 0xE8F1F8, 0xD5E6F3, 0xDCE3EA,
                                       0xCFE3F2, 0x0072B2, 0xBFC7D0, 0x22272E, 0x66707C};

void apply_colors(const WindowColors& c) {
    ImVec4* colors = ImGui::GetStyle().Colors;
    const auto set = [&](std::initializer_list<ImGuiCol> which, const ImVec4& value) {
        for (const ImGuiCol i : which) colors[i] = value;
    };
    set({ImGuiCol_WindowBg, ImGuiCol_MenuBarBg, ImGuiCol_ScrollbarBg}, color(c.window));
    set({ImGuiCol_PopupBg}, color(c.popup));
    set({ImGuiCol_ChildBg, ImGuiCol_TableRowBg}, color(c.window, 0));
    set({ImGuiCol_FrameBg}, color(c.frame));
    set({ImGuiCol_FrameBgHovered}, color(c.frame_hovered));
    set({ImGuiCol_FrameBgActive}, color(c.frame_active));
    set({ImGuiCol_Button, ImGuiCol_Tab, ImGuiCol_TabUnfocused, ImGuiCol_ScrollbarGrab}, color(c.button));
    set({ImGuiCol_ButtonHovered, ImGuiCol_TabHovered, ImGuiCol_ScrollbarGrabHovered}, color(c.accent, 0.45f));
    set({ImGuiCol_ButtonActive, ImGuiCol_ScrollbarGrabActive}, color(c.accent, 0.7f));
    set({ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive, ImGuiCol_Header}, color(c.header));
    set({ImGuiCol_HeaderHovered}, color(c.accent, 0.35f));
    set({ImGuiCol_HeaderActive}, color(c.accent, 0.5f));
    set({ImGuiCol_SliderGrab}, color(c.accent, 0.55f));  // digits behind it stay legible
    set({ImGuiCol_SliderGrabActive}, color(c.accent, 0.75f));
    set({ImGuiCol_CheckMark, ImGuiCol_PlotHistogram}, color(c.accent));
    set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong},
        color(c.border));
    set({ImGuiCol_TableHeaderBg}, color(c.frame));
    set({ImGuiCol_TableRowBgAlt}, color(c.text, 0.04f));
    set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}, color(c.header));
    set({ImGuiCol_Text}, color(c.text));
    set({ImGuiCol_TextDisabled}, color(c.dim));
    set({ImGuiCol_TextSelectedBg}, color(c.accent, 0.4f));
    set({ImGuiCol_ModalWindowDimBg}, color(0x000000, 0.35f));
}

}  // namespace

const Palette& palette(ThemeKind kind) {
    return kind == ThemeKind::dark ? DARK : LIGHT;
}

void load_fonts(float scale) {
    constexpr const char* REGULAR = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    constexpr const char* BOLD = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
    constexpr float SIZE = 15.0f;  // pixels at scale 1
    static const ImWchar ranges[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2027, 0x2070, 0x209F, 0x2100,
                                     0x214F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};
    for (const char* font : {REGULAR, BOLD}) {
        std::error_code code;  // a folder that cannot be entered has no fonts either
        if (!std::filesystem::exists(font, code))
            throw Error("The font DejaVu Sans is missing; install the package fonts-dejavu-core.");
    }
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->AddFontFromFileTTF(REGULAR, SIZE * scale, nullptr, ranges);
    io.Fonts->AddFontFromFileTTF(BOLD, SIZE * scale, nullptr, ranges);
    io.IniFilename = nullptr;               // write no settings file
    io.ConfigInputTextCursorBlink = false;  // a blinking cursor would redraw an idle window
    io.ConfigWindowsMoveFromTitleBarOnly = true;
}

ImFont* bold_font() {
    return ImGui::GetIO().Fonts->Fonts[1];
}

void apply_style(ThemeKind kind, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    if (kind == ThemeKind::dark)
        ImGui::StyleColorsDark();
    else
        ImGui::StyleColorsLight();
    apply_colors(kind == ThemeKind::dark ? DARK_WINDOW : LIGHT_WINDOW);
    style.WindowRounding = 0;
    style.PopupRounding = 4;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.TabRounding = 3;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = kind == ThemeKind::light ? 1.0f : 0.0f;
    style.WindowPadding = {8, 6};
    style.ItemSpacing = {7, 5};
    style.FramePadding = {6, 3};
    style.CellPadding = {4, 2};
    style.ScaleAllSizes(scale);
}

}  // namespace momentscope::ui
