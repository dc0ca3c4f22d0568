#include "ui/model/lessons.hpp"

#include <algorithm>

#include "ui/model/selection.hpp"

namespace momentscope::ui {

namespace {

void show(PlotState& plot, std::initializer_list<Series> series) {
    plot.shown.fill(false);
    for (const Series one : series) plot.shown[static_cast<std::size_t>(one)] = true;
}

// Places at half the height of the picture of `planes`, where this many sheets overlap.
constexpr glm::vec2 TWO_SHEETS(0.29f, 0.5f), THREE_SHEETS(0.39f, 0.5f), FOUR_SHEETS(0.5f, 0.5f);

void prepare_two_sheets(ExplorerState& state) {
    choose_scene(state, "planes");
    state.technique = &require_technique("power4-32");
    state.picked = TWO_SHEETS;
    state.marked = 1;  // the farther sheet
    show(state.plot, {Series::truth, Series::reconstruction, Series::bounds, Series::stems, Series::errors});
}

void prepare_four_surfaces(ExplorerState& state) {
    choose_scene(state, "planes");
    state.technique = &require_technique("power8-32");
    state.picked = FOUR_SHEETS;
    state.pins = {THREE_SHEETS};
    show(state.plot, {Series::truth, Series::reconstruction, Series::bounds, Series::unbiased_exact});
}

void prepare_wrapping_zone(ExplorerState& state) {
    choose_scene(state, "teapots");
    state.technique = &require_technique("trig2-32");
    state.parameters.set(ParameterId::theta, 0.0f);
    state.plot.query = -0.27f;  // just before a jump
    show(state.plot, {Series::truth, Series::reconstruction, Series::stems, Series::wrapping_zone});
}

void prepare_bias(ExplorerState& state) {
    choose_scene(state, "spheres");
    state.technique = &require_technique("power8-32");
    state.parameters.set(ParameterId::alpha, 0.0f);
    state.failures = true;
    show(state.plot, {Series::truth, Series::reconstruction, Series::bounds, Series::unbiased_exact});
}

void prepare_more_moments(ExplorerState& state) {
    choose_scene(state, "teapots");
    state.technique = &require_technique("power4-32");
    state.compared = {&require_technique("power8-32"), &require_technique("trig4-32")};
    state.panel = Panel::fragments;
    show(state.plot, {Series::truth, Series::reconstruction, Series::errors});
}

void prepare_knowledge(ExplorerState& state) {
    choose_scene(state, "teapots");
    state.technique = &require_technique("cheb4-32");
    show(state.plot, {Series::truth, Series::reconstruction, Series::bounds, Series::errors});
}

constexpr Lesson LESSONS[] = {
    {"beta", "β on two sheets",
     "Two sheets lie on this ray, and four moments determine them exactly: the two bounds differ only at the "
     "sheets themselves. Drag the overestimation weight β from 0 to 1 and watch the orange dots at the "
     "sheets' own depths.",
     "How much of its own absorbance counts as in front of a sheet?",
     "The share β of it. With β = 0 the reconstruction at the sheet is the lower bound, which here is the "
     "truth; with β = 1 it is the upper bound, and the sheet dims itself by its whole absorbance.",
     prepare_two_sheets},
    {"surfaces", "Three and four surfaces",
     "Four sheets lie on this ray, and three on the pinned one below. Eight power moments determine four "
     "surfaces (Fig. 3 of the paper): the dashed \"exact, no bias\" curve hits every step.",
     "Why does the orange curve miss the steps, and does it still miss them when you drag the moment bias α down to 1e-7?",
     "Table 1 of the supplementary gives eight moments in 32-bit floats a bias of 5e-5, and bias blurs the "
     "result. With 1e-7 the steps come back and the band closes. Press 1: four moments determine "
     "only two surfaces, so even their \"exact, no bias\" curve is a ramp.",
     prepare_four_surfaces},
    {"wrapping", "The wrapping zone",
     "Trigonometric moments bend the depth range into a circle, so its far end touches its near end. "
     "Without a wrapping zone (θ = 0), the orange curve jumps where a canonical mass passes from one end "
     "to the other (Fig. 4b).",
     "Move the query depth across a jump, then drag θ to 0.3: what happens to the jumps?",
     "A mass that wraps from the far end to the near end suddenly counts as in front, which makes the jump. "
     "A zone of angle θ lets it fade in: jumps turn into ramps. A wider zone is smoother but less precise "
     "in depth.",
     prepare_wrapping_zone},
    {"bias", "Moment bias",
     "The moment bias α is 0 here. In hatched pixels, the matrix of moments was singular. For up to four surfaces "
     "it is singular even in exact arithmetic; for more, rounding to 32-bit floats makes it singular. "
     "The dashed curve is the \"exact, no bias\" curve.",
     "Tick auto beside the moment bias α: which pixels recover, and what does the bias cost?",
     "With the bias of Table 1 of the supplementary no matrix is singular, and the hatching disappears. The "
     "price is blur: the biased curve leaves the \"exact, no bias\" curve and rounds off its steps.",
     prepare_bias},
    {"moments", "More moments on the teapots",
     "This ray passes through more than a dozen surfaces of teapots, far more than any of these moments can "
     "determine. The table lists the transmittance that four moments give each fragment.",
     "Press 1 to 6: does the greatest error of T shrink with more moments, and what do they cost?",
     "Yes: from four to six to eight power moments, and again from two to four trigonometric ones. But each "
     "step gains less, while the bits per pixel grow from 160 to 288. Do not use more moments than a scene needs.",
     prepare_more_moments},
    {"knowledge", "What else do you know?",
     "Four moments of this ray leave a wide band. But more is known: each fragment knows its own absorbance, "
     "and nothing lies beyond the nearest and the farthest one. Below, set in this order: estimate to expected, "
     "ends to known, interval to pixel, renormalisation to uncertain.",
     "How much of the error is left after the four clicks, from the same four moments?",
     "Each click adds what is known for certain: a fragment does not occlude itself, the first one is not occluded "
     "at all, no mass lies beyond the ends, and what is uncertain pays for what is missing. The technique sharp4 "
     "has all four turned on.",
     prepare_knowledge, true},
};

}  // namespace

std::span<const Lesson> lessons() {
    return LESSONS;
}

const Lesson* find_lesson(std::string_view id) {
    const auto* found =
        std::ranges::find(LESSONS, id, [](const Lesson& lesson) { return std::string_view(lesson.id); });
    return found == std::end(LESSONS) ? nullptr : found;
}

void open_lesson(ExplorerState& state, const Lesson& lesson) {
    ExplorerState fresh;
    fresh.theme = state.theme;
    fresh.scene_share = state.scene_share;
    fresh.plot_share = state.plot_share;
    lesson.prepare(fresh);
    fresh.card = lesson.id;
    state = fresh;
}

}  // namespace momentscope::ui
