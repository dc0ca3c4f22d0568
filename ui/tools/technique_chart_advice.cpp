// technique_chart_advice.cpp -- the bounds on error and bits, and the techniques that meet them.
#include <fmt/format.h>

#include "core/report/advice_text.hpp"
#include "ui/tools/technique_chart.hpp"

namespace momentscope::ui {

namespace {

constexpr int MAX_BITS = 4096;

float greatest_error(Metric metric) {
    return metric == Metric::delta_e ? 50.0f : metric == Metric::flip ? 0.99f : 1.0f;
}

}  // namespace

void TechniqueChart::draw_error_bound(const Ui& ui, float right) {
    ImGui::SetNextItemWidth(5.5f * em());
    if (ImGui::BeginCombo("##metric", metrics()[static_cast<std::size_t>(bounds_.metric)].symbol)) {
        for (const MetricRow& row : metrics()) {
            if (ImGui::Selectable(row.symbol, bounds_.metric == row.id)) {
                bounds_.max_error *=
                    static_cast<double>(greatest_error(row.id) / greatest_error(bounds_.metric));
                bounds_.metric = row.id;
            }
            ui.record_widget_rect(fmt::format("chart.metric.{}", row.key));
        }
        ImGui::EndCombo();
    }
    ui.record_widget_rect("chart.metric");
    tooltip("The metric of the chart and of the advice.");
    flow(9 * em(), right, 0.5f * em());
    ImGui::SetNextItemWidth(9 * em());
    const float most = greatest_error(bounds_.metric);
    auto error = static_cast<float>(bounds_.max_error);
    if (ImGui::SliderFloat("##max_error", &error, 1e-4f * most, most, "at most %.3g",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        bounds_.max_error = static_cast<double>(error);
    ui.record_widget_rect("chart.max_error");
    tooltip("The greatest error that you accept. It also holds at other views than the measured one.",
            "Ctrl+click to type");
}

void TechniqueChart::draw_bits_bound(const Ui& ui, float right) {
    flow(button_width("bits") + 8 * em(), right, 0.5f * em());
    ImGui::Checkbox("bits", &bounds_bits_);
    ui.record_widget_rect("chart.bounds_bits");
    tooltip("Limits what a pixel stores in addition to the colour buffers.");
    if (bounds_bits_) {
        ImGui::SameLine();
        ImGui::SetNextItemWidth(7 * em());
        ImGui::SliderInt("##bits", &bits_, 1, MAX_BITS, "at most %d",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        ui.record_widget_rect("chart.max_bits");
        tooltip("Bits per pixel.", "Ctrl+click to type");
    }
}

void TechniqueChart::draw_bounds(const Ui& ui) {
    label("error");
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    draw_error_bound(ui, right);
    draw_bits_bound(ui, right);
    flow(button_width("any order") + 1.5f * em(), right, 0.5f * em());
    ImGui::Checkbox("any order", &bounds_.order_independent);
    ui.record_widget_rect("chart.order_independent");
    tooltip("Leaves out techniques that depend on the order of submission.");
}

void TechniqueChart::draw_row(const Ui& ui, const char* name, std::optional<std::size_t> row,
                              const char* otherwise, bool stale, ExplorerState& state) {
    label(name);
    if (!row) return ImGui::TextDisabled("%s", otherwise);
    ImGui::BeginDisabled(stale);
    if (ImGui::Button(fmt::format("use##{}", name).c_str())) use(*row, state);
    ImGui::EndDisabled();
    ui.record_widget_rect(fmt::format("chart.use.{}", name));
    tooltip("Draws the picture with this technique and these parameters.");
    ImGui::SameLine();
    const ChartRow& of = measurement_.rows()[*row];
    ImGui::TextWrapped("%s",
                       fmt::format("{}: {}", short_name(of.configuration),
                                   cost_text(of, bounds_.metric, measurement_.held_out(bounds_.metric)[*row]))
                           .c_str());
    tooltip(numbers_of(*row));
}

void TechniqueChart::draw_advice(const Ui& ui, bool stale, ExplorerState& state) {
    if (!advice_) return;
    if (advice_->winner) {
        draw_row(ui, "cheapest", advice_->winner, "", stale, state);
        draw_row(ui, "runner-up", advice_->runner_up, "Nothing else meets the bounds.", stale, state);
        draw_row(ui, "half error", advice_->next_better, "Only a ground truth has it.", stale, state);
    } else {
        ImGui::TextWrapped("%s", no_advice_text(measurement_.rows(), bounds_,
                                                measurement_.held_out(bounds_.metric), *advice_)
                                     .c_str());
        ui.record_widget_rect("chart.nothing");
        draw_row(ui, "nearest", advice_->nearest, "No row is a candidate.", stale, state);
    }
    ImGui::TextDisabled("%s", measurement_.busy() ? "From the rows so far, at their own view only."
                              : checking_         ? "Checking at other views…"
                              : stale             ? "At their own view only."
                                                  : "Checked at six other views.");
    ui.record_widget_rect("chart.checked");
}

}  // namespace momentscope::ui
