#include "ui/tools/tuning.hpp"

#include <fmt/format.h>

#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope::ui {

namespace {

constexpr glm::ivec2 TUNED_SIZE(64, 36);  // enough pixels to cover a scene evenly

}  // namespace

void Tuning::start(const ExplorerState& state, const Scene& scene, const Renderer& renderer,
                   Status& status) try {
    std::vector<ViewRay> rays;
    if (state.ray) {
        rays.push_back(*state.ray);
    } else {
        Renderer small(renderer.programs());
        small.set_scene(scene);
        small.render({state.camera.value_or(scene.camera), TUNED_SIZE, &require_technique("sorted"),
                      state.parameters});
        for (PixelCapture& capture : small.capture_region({0, 0}, TUNED_SIZE))
            rays.push_back(std::move(capture.ray));
    }
    technique_ = state.technique;
    const TuneOptions options = {.technique = state.technique, .values = state.parameters};
    work_.start([rays = std::move(rays), options](const std::stop_token& stop, const auto& report) {
        return tune_in_parts(rays, options, stop, report);
    });
} catch (const Error& error) {
    status.say(error.what());
}

void Tuning::poll(ExplorerState& state, Status& status) {
    try {
        const auto result = work_.take();
        if (!result || !*result) return;
        const TuneResult& tuned = **result;
        if (technique_ != state.technique) {
            status.say("Another technique was chosen meanwhile, so the result of tuning was not applied.");
            return;
        }
        state.parameters = tuned.values;
        status.say(
            fmt::format("Tuned: error of T {:.4f} instead of {:.4f}{}; Ctrl+Z brings the old values back.",
                        tuned.error, tuned.error_before,
                        tuned.safe ? "" : ", but no moment bias kept failures below one in a thousand"));
    } catch (const Error& error) {
        status.say(error.what());
    }
}

bool Tuning::draw(const Ui& ui, const ExplorerState& state) {
    if (!state.technique->has_moments() && !work_.busy()) return false;
    ImGui::Spacing();
    if (!work_.busy()) {
        const bool asked = ImGui::Button("tune α, θ, β");
        ui.record_widget_rect("controls.tune");
        tooltip(
            "Searches for the moment bias, the wrapping zone angle and the overestimation weight with the least error "
            "against the truth, over the pixels of this scene or for this ray. The paper advises tuning them by hand.",
            "momentscope tune");
        return asked;
    }
    ImGui::ProgressBar(work_.share(), {12 * em(), 0});
    ui.record_widget_rect("controls.tune.progress");
    ImGui::SameLine();
    if (ImGui::Button("cancel##tune")) work_.cancel();
    ui.record_widget_rect("controls.tune.cancel");
    tooltip("Ends the search and keeps the parameters.");
    return false;
}

}  // namespace momentscope::ui
