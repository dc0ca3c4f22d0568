#include "ui/window/notices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>

#include "ui/picture/pixel_lens.hpp"
#include "ui/widgets/shortcut.hpp"

namespace momentscope::ui {

namespace {

// Before the first picture: the program's name above the scene's, in the middle of the window.
void draw_opening(ImDrawList& list, const Workspace& w) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    list.AddRectFilled({0, 0}, size, ImGui::GetColorU32(ImGuiCol_WindowBg));
    const auto centered = [&](ImFont* font, float height, float y, ImU32 tint, const std::string& text) {
        const float width = font->CalcTextSizeA(height, FLT_MAX, 0, text.c_str()).x;
        list.AddText(font, height, {0.5f * (size.x - width), y}, tint, text.c_str());
    };
    const float middle = 0.45f * size.y;
    centered(bold_font(), em(), middle - 1.6f * em(), ImGui::GetColorU32(ImGuiCol_CheckMark), "Momentscope");
    centered(ImGui::GetFont(), em(), middle, ImGui::GetColorU32(ImGuiCol_TextDisabled),
             fmt::format("drawing {}…", std::filesystem::path(w.state.scene).filename().string()));
}

}  // namespace

void draw_waiting(ImDrawList& list, const Workspace& w) {
    if (w.picked.empty()) return draw_opening(list, w);
    const auto scene = w.widget_rects.find("scene");
    if (scene == w.widget_rects.end()) return;
    constexpr const char* WORD = "drawing…";
    const Rect& area = scene->second;
    const ImVec2 extent = ImGui::CalcTextSize(WORD);
    draw_label(list,
               {0.5f * (area.low.x + area.high.x - extent.x), 0.5f * (area.low.y + area.high.y - extent.y)},
               WORD, palette(w.state.theme));
}

void draw_reading_notice(const Ui& ui, Workspace& w) {
    if (!w.status.progress) return;
    const Status::Progress& progress = *w.status.progress;
    const ImVec2 room = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowPos({0.5f * room.x, 0.4f * room.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(26 * em(), room.x), 0});
    ImGui::Begin("Reading###loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextWrapped("Reading %s", progress.what.c_str());
    const float top = ImGui::GetCursorPosY();
    ImGui::TextWrapped("%s", progress.step.c_str());
    // Keep the button in place, however long the text is.
    ImGui::SetCursorPosY(top + 3 * ImGui::GetTextLineHeightWithSpacing());
    const double seconds = progress.seconds;
    const auto sweep =
        static_cast<float>(seconds - std::floor(seconds));  // the duration is not known in advance
    ImGui::ProgressBar(sweep, {-1, 0}, fmt::format("{:.1f} s", seconds).c_str());
    if (ImGui::Button("Cancel", {6 * em(), 0}) || pressed({.key = 256})) w.scene.cancel_reading();
    ui.record_widget_rect("loading.cancel");
    tooltip("Stops reading; the previous scene stays.", "Escape");
    ImGui::End();
}

}  // namespace momentscope::ui
