// explorer_waiting.cpp -- the notice that the window shows while it draws a picture.
#include <fmt/format.h>

#include <cfloat>
#include <filesystem>
#include <string>

#include "ui/explorer.hpp"
#include "ui/theme.hpp"

namespace momentscope::ui {

PictureKind Explorer::picture_kind(const View& view, Stage stage) const {
    PictureKind kind = {.scene = state_.scene, .technique = view.technique, .stage = stage};
    for (const Parameter& row : parameters())
        if (row.scale != Scale::linear && row.scale != Scale::logarithmic)
            kind.choices.push_back(view.parameters[row.id]);
    if (wants_reference()) {
        kind.reference = state_.compare.reference;
        kind.reference_stage =
            reference_ == nullptr ? Stage::opaque : first_stale_stage(reference_view_, reference_view(view));
    }
    kind.failures = state_.failures && (stage <= Stage::color || !shown_state_.failures);
    return kind;
}

// Called before anything is drawn, while the window still shows the last frame.
void Explorer::announce(const PictureKind& kind, glm::ivec2 size) const {
    if (!options_.before_long_picture) return;
    if (kind.stage == Stage::nothing && kind.reference_stage == Stage::nothing && !kind.failures) return;
    const auto expected = picture_times_.expected(kind, size);
    if (!expected || *expected > options_.most_silent_milliseconds) options_.before_long_picture();
}

void Explorer::draw_waiting(ImDrawList& list) const {
    if (measurement_.curve.technique == nullptr) return draw_opening(list);
    const auto scene = widget_rects_.find("scene");
    if (scene == widget_rects_.end()) return;
    constexpr const char* WORD = "drawing…";
    const Rect& area = scene->second;
    const ImVec2 extent = ImGui::CalcTextSize(WORD);
    draw_label(list,
               {0.5f * (area.low.x + area.high.x - extent.x), 0.5f * (area.low.y + area.high.y - extent.y)},
               WORD, palette(state_.theme));
}

// Before the first picture: the program's name above the scene's, in the middle of the window.
void Explorer::draw_opening(ImDrawList& list) const {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    list.AddRectFilled({0, 0}, size, ImGui::GetColorU32(ImGuiCol_WindowBg));
    const auto centered = [&](ImFont* font, float height, float y, ImU32 tint, const std::string& text) {
        const float width = font->CalcTextSizeA(height, FLT_MAX, 0, text.c_str()).x;
        list.AddText(font, height, {0.5f * (size.x - width), y}, tint, text.c_str());
    };
    const float middle = 0.45f * size.y;
    centered(bold_font(), em(), middle - 1.6f * em(), ImGui::GetColorU32(ImGuiCol_CheckMark), "Momentscope");
    centered(ImGui::GetFont(), em(), middle, ImGui::GetColorU32(ImGuiCol_TextDisabled),
             fmt::format("drawing {}…", std::filesystem::path(state_.scene).filename().string()));
}

}  // namespace momentscope::ui
