// explorer_tuning.cpp -- the button that searches for the best parameters in the background.
#include <fmt/format.h>

#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "ui/explorer.hpp"

namespace momentscope::ui {

namespace {

constexpr glm::ivec2 TUNED_SIZE(64, 36);  // enough pixels to cover a scene evenly

}  // namespace

void Explorer::start_tuning() try {
    std::vector<ViewRay> rays;
    if (state_.ray) {
        rays.push_back(*state_.ray);
    } else {
        Renderer small(renderer_.programs());
        small.set_scene(scene_);
        small.render({camera(), TUNED_SIZE, &require_technique("sorted"), state_.parameters});
        for (PixelCapture& capture : small.capture_region({0, 0}, TUNED_SIZE))
            rays.push_back(std::move(capture.ray));
    }
    tuned_technique_ = state_.technique;
    const TuneOptions options = {.technique = state_.technique, .values = state_.parameters};
    tuning_.start([rays = std::move(rays), options](std::stop_token stop, const auto& report) {
        return tune(rays, options, stop, report);
    });
} catch (const Error& error) {
    message_ = error.what();
}

// Called once per frame, whichever tab is open.
void Explorer::poll_tuning() {
    try {
        const auto result = tuning_.take();
        if (!result || !*result) return;
        const TuneResult& tuned = **result;
        if (tuned_technique_ != state_.technique) {
            message_ = "Another technique was chosen meanwhile, so the result of tuning was not applied.";
            return;
        }
        state_.parameters = tuned.values;
        message_ =
            fmt::format("Tuned: error of T {:.4f} instead of {:.4f}{}; Ctrl+Z brings the old values back.",
                        tuned.error, tuned.error_before,
                        tuned.safe ? "" : ", but no moment bias kept failures below one in a thousand");
    } catch (const Error& error) {
        message_ = error.what();
    }
}

void Explorer::draw_tuning(const Ui& ui) {
    if (!state_.technique->has_moments() && !tuning_.busy()) return;
    ImGui::Spacing();
    if (!tuning_.busy()) {
        if (ImGui::Button("tune α, θ, β")) start_tuning();
        ui.record_widget_rect("controls.tune");
        tooltip(
            "Searches for the moment bias, the wrapping zone angle and the overestimation weight with the least error "
            "against the truth, over the pixels of this scene or for this ray. The paper advises tuning them by hand.",
            "momentscope tune");
        return;
    }
    ImGui::ProgressBar(tuning_.share(), {12 * em(), 0});
    ui.record_widget_rect("controls.tune.progress");
    ImGui::SameLine();
    if (ImGui::Button("cancel##tune")) tuning_.cancel();
    ui.record_widget_rect("controls.tune.cancel");
    tooltip("Ends the search and keeps the parameters.");
}

}  // namespace momentscope::ui
