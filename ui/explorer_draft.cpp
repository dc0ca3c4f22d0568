// explorer_draft.cpp -- the draft of the picture while a control moves.
#include "ui/explorer.hpp"

namespace momentscope::ui {

// Returns true while the mouse drags and the picture takes too long, until the mouse rests.
bool Explorer::wants_draft(const View& view, Stage stage) {
    constexpr float REST_SECONDS = 0.2f;
    if (stage == Stage::nothing || shown_view_.technique == nullptr) return false;
    const PassTimes& t = renderer_.pass_times();
    const double milliseconds = t.composite + (stage <= Stage::color ? t.color : 0) +
                                (stage <= Stage::moments ? t.moments : 0) +
                                (stage <= Stage::opaque || stage == Stage::shading ? t.opaque : 0);
    if (!ImGui::IsAnyMouseDown() || milliseconds <= options_.most_milliseconds) return false;
    const bool still = shows_draft() && first_stale_stage(draft_view_, view) == Stage::nothing;
    still_seconds_ = still ? still_seconds_ + ImGui::GetIO().DeltaTime : 0;
    return still_seconds_ < REST_SECONDS;
}

// The plot stays exact because it uses all fragments at the picked place. While the camera moves, that place
// is accurate to a pixel of the draft.
void Explorer::draw_draft(const View& view, Stage stage) {
    if (first_stale_stage(draft_view_, view) != Stage::nothing) {
        draft_.draw(view, options_.most_milliseconds);
        draft_view_ = view;
        report_.draft = true;
        if (fragments_stale(view, stage)) {
            const glm::ivec2 pixel = pixel_of(state_.picked, scene_, view.size);
            measurement_.capture = draft_.capture(fraction_of(pixel, view.size));
            measurement_.light.reset();
            if (seen_from_light(state_)) {
                measurement_.light =
                    draft_.light(fraction_of(pixel, view.size), measurement_.capture, state_.receiver);
                measurement_.capture.ray =
                    measurement_.light ? ray_of(*measurement_.light, state_.viewpoint) : ViewRay();
            }
            report_.capture = draft_captured_ = true;
        }
        measurement_.capture.transmittance.clear();
        transmittance_stale_ = true;
    }
    picture_.texture = draft_.display_texture();
    picture_.overlay = 0;
    measure_if_changed(report_.capture);
}

}  // namespace momentscope::ui
