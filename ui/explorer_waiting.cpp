// explorer_waiting.cpp -- the word that says that a picture is being drawn.
#include "ui/explorer.hpp"

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

// Called before anything is drawn, when the last frame is still what the window shows.
void Explorer::announce(const PictureKind& kind, glm::ivec2 size) const {
    if (!options_.before_long_picture) return;
    if (kind.stage == Stage::nothing && kind.reference_stage == Stage::nothing && !kind.failures) return;
    const auto expected = picture_times_.expected(kind, size);
    if (!expected || *expected > options_.most_silent_milliseconds) options_.before_long_picture();
}

void Explorer::draw_waiting(ImDrawList& list) const {
    constexpr const char* WORD = "drawing…";
    const auto scene = widget_rects_.find("scene");
    if (scene == widget_rects_.end()) return;
    const Rect& area = scene->second;
    const ImVec2 extent = ImGui::CalcTextSize(WORD);
    draw_label(list,
               {0.5f * (area.low.x + area.high.x - extent.x), 0.5f * (area.low.y + area.high.y - extent.y)},
               WORD, palette(state_.theme));
}

}  // namespace momentscope::ui
