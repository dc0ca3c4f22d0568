#include "ui/picture/picture.hpp"

#include <algorithm>

namespace momentscope::ui {

bool PictureChange::changes_fragments() const {
    if (stage <= Stage::opaque || light_changed(before, now)) return true;  // new colours
    const bool reordered = std::ranges::any_of(PICTURE_PARAMETERS, [&](ParameterId id) {
        return parameter(id).invalidates <= Stage::moments && now.parameters[id] != before.parameters[id];
    });
    const bool mixed = stage <= Stage::moments && now.technique->uses(ParameterId::resolution);
    return reordered || mixed ||
           now.parameters[ParameterId::resolution] != before.parameters[ParameterId::resolution];
}

Picture::Picture(Renderer& renderer, double most_milliseconds)
    : renderer_(renderer), draft_(renderer.programs()), most_milliseconds_(most_milliseconds) {}

void Picture::set_scene(const Scene& scene) {
    renderer_.set_scene(scene);
    draft_.set_scene(scene);
    forget();
}

void Picture::set_objects(const Scene& scene) {
    renderer_.set_scene(scene);
    draft_.set_objects(scene.objects);
    forget();
}

PictureChange Picture::change_to(const View& view) const {
    return {shown_, view, first_stale_stage(shown_, view)};
}

bool Picture::wants_draft(const PictureChange& change, Pointer pointer) {
    constexpr float REST_SECONDS = 0.2f;
    const Stage stage = change.stage;
    if (stage == Stage::nothing || shown_.technique == nullptr) return false;
    const PassTimes& t = renderer_.pass_times();
    const double milliseconds = t.composite + (stage <= Stage::color ? t.color : 0) +
                                (stage <= Stage::moments ? t.moments : 0) +
                                (stage <= Stage::opaque || stage == Stage::shading ? t.opaque : 0);
    if (!pointer.held || milliseconds <= most_milliseconds_) return false;
    const bool still = shows_draft() && first_stale_stage(draft_view_, change.now) == Stage::nothing;
    still_seconds_ = still ? still_seconds_ + pointer.seconds : 0;
    return still_seconds_ < REST_SECONDS;
}

bool Picture::draw_draft(const View& view) {
    if (first_stale_stage(draft_view_, view) == Stage::nothing) return false;
    draft_.draw(view, most_milliseconds_);
    draft_view_ = view;
    return true;
}

void Picture::draw(const PictureChange& change, FrameReport& report) {
    const PassCounts before = renderer_.pass_counts();
    draft_view_.technique = nullptr;
    if (change.stage != Stage::nothing) renderer_.render(change.now);
    shown_ = change.now;
    const PassCounts& now = renderer_.pass_counts();
    report.opaque = now.opaque > before.opaque;
    report.first_pass = now.moments > before.moments;
    report.second_pass = now.color > before.color;
    report.composite = now.composite > before.composite;
}

}  // namespace momentscope::ui
