#include "ui/picture/scene_picture.hpp"

#include <fmt/format.h>

#include "ui/widgets/technique_combo.hpp"

namespace momentscope::ui {

namespace {

// A map of the differences between picture and reference, or of what the moments leave open.
void show_map(ScenePicture& picture, const ExplorerState& state, const PictureComparison& comparison) {
    const CompareState& compare = state.compare;
    const Comparison& numbers = comparison.numbers();
    const bool open = compare.mode == CompareMode::uncertainty;
    const char* name =
        open ? "Luminance left open" : metrics()[static_cast<std::size_t>(compare.metric)].name;
    const PixelNumbers* shown = open ? numbers.uncertainty() : numbers.result(compare.metric);
    if (numbers.map().mode == compare.mode) picture.texture = comparison.map_texture();
    if (compare.mode == CompareMode::difference)
        picture.title = fmt::format("|{} - {}| × {:.3g}, linear channels", state.technique->id,
                                    compare.reference->id, compare.gain);
    else if (shown != nullptr)
        picture.legend = {name, false_color_end(compare), shown->least, shown->most,
                          !open && !numbers.is_fresh(compare.metric)};
    else
        picture.title = fmt::format("{}: computing…", name);
}

void choose_picture(ScenePicture& picture, const ExplorerState& state, const Renderer& renderer,
                    const PictureComparison& comparison) {
    const CompareState& compare = state.compare;
    picture.texture = renderer.display_texture();
    picture.beside = 0;
    picture.legend.reset();
    picture.title.clear();
    if (comparison.flipped()) {
        if (has_comparison(state)) picture.texture = comparison.reference().texture();
        picture.title = fmt::format("reference: {}", technique_label(*compare.reference));
    } else if (compare.mode != CompareMode::off) {
        if (compare.mode == CompareMode::uncertainty && !shows_uncertainty(state))
            picture.title =
                fmt::format("{} has no moments, so nothing bounds its transmittances", state.technique->id);
        else if (compare.mode != CompareMode::uncertainty && !has_comparison(state))
            picture.title = "nothing to compare: the picture is the reference itself";
        else if (compare.mode == CompareMode::wipe)
            picture.beside = comparison.reference().texture();
        else
            show_map(picture, state, comparison);
    }
}

}  // namespace

void update_scene_picture(ScenePicture& picture, const Update& update, const PictureChange& change,
                          Renderer& renderer, const PictureComparison& comparison, glm::ivec2 picked) {
    const ExplorerState& state = update.state;
    FrameReport& report = update.report;
    choose_picture(picture, state, renderer, comparison);
    if (!state.failures) {
        picture.failures.reset();
    } else if (change.stage <= Stage::color || !update.shown.failures) {
        picture.failures = renderer.draw_failures();
        report.failures = true;
    }
    const bool own_picture = picture.texture == renderer.display_texture();
    picture.overlay = picture.failures && own_picture ? renderer.failure_texture() : 0;
    const bool changed =
        change.stage != Stage::nothing || report.reference || report.comparison || report.capture;
    const bool map = !own_picture && picture.texture == comparison.map_texture();
    update_lens(picture.lens, update, renderer, comparison, {picked, change.now.size, map, changed});
}

void show_draft(ScenePicture& picture, const DraftPicture& draft) {
    picture.texture = draft.display_texture();
    picture.overlay = 0;
}

}  // namespace momentscope::ui
