#include "ui/tools/stress_run.hpp"

#include <fmt/format.h>

#include "core/report/stress_report.hpp"
#include "ui/model/selection.hpp"
#include "ui/widgets/stress_map.hpp"

namespace momentscope::ui {

void StressRun::start(const ExplorerState& state) {
    StressOptions options;
    options.techniques = moment_based_techniques();
    for (const Condition& condition : conditions()) options.conditions.push_back(&condition);
    options.values = state.parameters;
    options.rays = rays_;
    title_ = stress_title(options);
    work_.start([options](const std::stop_token& stop, const auto& report) {
        return stress_in_parts(options, stop, report);
    });
}

void StressRun::draw_progress(const Ui& ui) {
    ImGui::ProgressBar(work_.share(), {14 * em(), 0});
    ui.record_widget_rect("stress.progress");
    ImGui::SameLine();
    if (ImGui::Button("cancel")) work_.cancel();
    ui.record_widget_rect("stress.cancel");
    tooltip("Ends the run; the previous map stays.");
}

void StressRun::open_worst(const StressCell& cell, ExplorerState& state, Status& status) {
    if (cell.worst_case.ray.fragments.size() > 2000) {
        status.say(
            fmt::format("The worst ray of that cell has {} fragments, too many to edit; click another cell.",
                        cell.worst_case.ray.fragments.size()));
        return;
    }
    state.technique = cell.technique;
    state.parameters = cell.worst_case.values;
    edit_ray(state, cell.worst_case.ray);
    mark(state, 0);
}

void StressRun::poll() {
    if (std::optional<std::vector<StressCell>> cells = work_.take(); cells && !cells->empty())
        cells_ = *std::move(cells);
}

void StressRun::draw(const Ui& ui, ExplorerState& state, Status& status) {
    if (work_.busy()) {
        draw_progress(ui);
    } else {
        if (ImGui::Button("run")) start(state);
        ui.record_widget_rect("stress.run");
        tooltip(
            "Tests every technique with moments under every condition, with the current solver, bias and β, and "
            "counts failures.");
        ImGui::SameLine();
        ImGui::SetNextItemWidth(9 * em());
        ImGui::SliderInt("##rays", &rays_, 10, 1000, "%d rays a cell",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        ui.record_widget_rect("stress.rays");
        tooltip("Number of random rays for each technique and condition. More rays find rarer failures.");
    }
    if (cells_.empty()) {
        ImGui::TextWrapped(
            "A map of failures, with a cell for each technique and condition. A failure is a result that is not finite, or "
            "outside [0, b₀], or with T off by more than 0.02 from the exact result at the same moment bias. Press run. A "
            "click in the map opens the worst ray of a cell in the editor.");
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", title_.c_str());
    ImGui::PopStyleColor();
    ImGui::BeginChild("map", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
    const auto clicked = draw_stress_map(ui, cells_);
    ImGui::EndChild();
    if (clicked) open_worst(cells_[*clicked], state, status);
}

}  // namespace momentscope::ui
