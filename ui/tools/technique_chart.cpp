#include "ui/tools/technique_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bench/chart_run.hpp"
#include "core/chart/chart_csv.hpp"
#include "core/chart/grid.hpp"
#include "core/report/chart_drawing.hpp"
#include "core/report/chart_html.hpp"
#include "core/report/family.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "ui/widgets/drawing_painter.hpp"

namespace momentscope::ui {

namespace {

constexpr std::array SIZES = {glm::ivec2(160, 90), glm::ivec2(320, 180), glm::ivec2(640, 360)};
constexpr double SLICE = 0.03;  // seconds of a frame for measuring, plus the picture that has begun

// The parameters that every picture of a chart depends on, besides those of its technique.
ParameterValues picture_values(const ParameterValues& values) {
    ParameterValues result;
    for (const ParameterId id : CHART_PARAMETERS) result.set(id, values[id]);
    return result;
}

std::vector<Configuration> grid_of(bool standards_only, const ParameterValues& values) {
    if (!standards_only) return chart_grid(values);
    std::vector<Configuration> all;
    for (const Technique& technique : techniques()) all.push_back({&technique, values});
    return all;
}

std::string size_text(glm::ivec2 size) {
    return fmt::format("{} x {}", size.x, size.y);
}

// Drawings are designed for a font size of 14 pixels.
float drawing_scale() {
    return em() / 14;
}

}  // namespace

bool TechniqueChart::is_stale(const ExplorerState& state) const {
    return measurement_.scene() != state.scene ||
           measurement_.settings().values != picture_values(state.parameters);
}

void TechniqueChart::start(const Scene& scene, const ExplorerState& state, Status& status) {
    if (state.ray) return;
    const ParameterValues values = picture_values(state.parameters);
    ChartSettings settings;
    settings.size = SIZES[size_];
    settings.values = values;
    advice_.reset();
    drawn_ = {};
    try {
        measurement_.start(scene, grid_of(standards_only_, values), settings);
    } catch (const Error& error) {
        cancel();
        status.say(error.what());
    }
}

void TechniqueChart::update_advice() {
    bounds_.max_bits = bounds_bits_ ? std::optional(bits_) : std::nullopt;
    if (measurement_.rows().empty()) return advice_.reset();
    advice_ = advise(measurement_.rows(), bounds_, measurement_.held_out(bounds_.metric));
}

void TechniqueChart::work(const ExplorerState& state, Status& status) {
    checking_ = false;
    try {
        if (measurement_.busy() && is_stale(state)) {
            cancel();
            status.say("The scene or its order changed, so the chart was stopped; measure again.");
        }
        if (measurement_.busy()) measurement_.advance(SLICE);
        if (state.panel != Panel::chart) return;
        update_advice();
        if (measurement_.busy() || !advice_ || is_stale(state)) return;
        if (const auto row = unchecked(*advice_, measurement_.held_out(bounds_.metric))) {
            measurement_.check(*row, bounds_.metric);
            checking_ = true;
        }
    } catch (const Error& error) {
        cancel();
        status.say(error.what());
    }
}

void TechniqueChart::use(std::size_t row, ExplorerState& state) const {
    const Configuration& configuration = measurement_.configuration(row);
    state.technique = configuration.technique;
    for (const ParameterId id : configuration.technique->parameters)
        state.parameters.set(id, configuration.values[id]);
}

std::string TechniqueChart::numbers_of(std::size_t row) const {
    const ChartRow& of = measurement_.rows()[row];
    const ChartNumbers& n = *of.numbers;
    return fmt::format(
        "{}\n{}, {}\ntotal {:.2f} ms (pass 1 {:.2f}, pass 2 {:.2f}, composite {:.2f})\nRMSE {:.3g}   ΔE {:.3g}   "
        "FLIP {:.3g}   stability {:.1e}\n{}",
        of.configuration, measurement_.configuration(row).technique->name,
        family_of(*measurement_.configuration(row).technique).name, n.total.median, n.moments.median,
        n.color.median, n.composite.median, n.rmse, n.delta_e, n.flip, n.stability,
        n.bits_with_factor ? fmt::format("{} bits per pixel", *n.bits_with_factor)
                           : std::string("bits that grow with the number of layers"));
}

void TechniqueChart::draw_sizes(const Ui& ui) {
    if (ImGui::BeginCombo("##size", size_text(SIZES[size_]).c_str())) {
        for (std::size_t i = 0; i < SIZES.size(); ++i) {
            if (ImGui::Selectable(size_text(SIZES[i]).c_str(), size_ == i)) size_ = i;
            ui.record_widget_rect(fmt::format("chart.size.{}", SIZES[i].x));
        }
        ImGui::EndCombo();
    }
    ui.record_widget_rect("chart.size");
    tooltip("Size of the pictures that are measured.");
}

// Returns true if the user wants to save a file.
bool TechniqueChart::draw_controls(const Ui& ui, const Scene& scene, const ExplorerState& state,
                                   Status& status) {
    if (measurement_.busy()) {
        const float share =
            static_cast<float>(measurement_.steps_done()) / static_cast<float>(measurement_.steps());
        ImGui::ProgressBar(share, {18 * em(), 0},
                           fmt::format("{} of {}, {:.0f} s left", measurement_.steps_done(),
                                       measurement_.steps(), std::ceil(measurement_.seconds_left()))
                               .c_str());
        ui.record_widget_rect("chart.progress");
        ImGui::SameLine();
        if (ImGui::Button("cancel")) cancel();
        ui.record_widget_rect("chart.cancel");
        tooltip("Ends the measurement; finished rows stay.");
        return false;
    }
    if (ImGui::Button("measure")) start(scene, state, status);
    ui.record_widget_rect("chart.measure");
    tooltip(
        "Draws the scene's own view with every technique and measures its time and its error. You can use the "
        "window meanwhile, but what it draws disturbs the times.");
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(7 * em());
    draw_sizes(ui);
    flow(button_width("standard parameters only") + 1.5f * em(), right, 0.5f * em());
    ImGui::Checkbox("standard parameters only", &standards_only_);
    ui.record_widget_rect("chart.standards_only");
    tooltip(
        "Measures every technique only once, without the grid of its parameters. This takes about half the time.");
    if (measurement_.rows().empty()) return false;
    flow(button_width("save…"), right, 0.5f * em());
    const bool asked = ImGui::Button("save…");
    ui.record_widget_rect("chart.save");
    tooltip("Writes the rows as CSV, or the chart as HTML, SVG or Markdown.");
    return asked;
}

void TechniqueChart::update_drawing(glm::vec2 size) {
    const Drawn wanted = {measurement_.rows().size(), bounds_.metric, size};
    if (drawn_ == wanted) return;
    drawing_ = chart_drawing(measurement_.rows(), bounds_.metric, "",
                             {size / drawing_scale(), false, size.y >= 20 * em()});
    drawn_ = wanted;
}

void TechniqueChart::draw_chart(const Ui& ui, bool stale, ExplorerState& state) {
    const float scale = drawing_scale();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // The advice is below the chart. If there is little space, the user scrolls to it, and the names of
    // families appear only under the mouse.
    const glm::vec2 size(std::max(room.x, 20 * em()), std::max(room.y - 10.5f * em(), 13.5f * em()));
    update_drawing(size);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("chart", {size.x, size.y});
    const bool hovered = ImGui::IsItemHovered();
    const bool clicked = ImGui::IsItemClicked();
    ui.record_widget_rect("chart.plot");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = {origin.x + size.x, origin.y + size.y};
    list.AddRectFilled(origin, end, IM_COL32_WHITE, 0.3f * em());
    paint_drawing(list, drawing_, origin, scale);
    if (stale) list.AddRectFilled(origin, end, IM_COL32(225, 225, 225, 170), 0.3f * em());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Drawing::Mark* nearest = nullptr;
    float least = em();
    for (const Drawing::Mark& mark : drawing_.marks) {
        if (mark.row == Drawing::NO_ROW) continue;
        const ImVec2 at = {origin.x + scale * mark.at.x, origin.y + scale * mark.at.y};
        const float radius = scale * mark.radius;
        ui.widget_rects[fmt::format("chart.{}", measurement_.rows()[mark.row].configuration)] = {
            {at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}};
        if (advice_ && advice_->winner == mark.row)
            list.AddCircle(at, radius + 0.45f * em(), IM_COL32(213, 0, 50, 255), 0, 0.15f * em());
        const float distance = std::hypot(mouse.x - at.x, mouse.y - at.y);
        if (!hovered || distance >= least) continue;
        least = distance;
        nearest = &mark;
    }
    if (nearest == nullptr) return;
    tooltip(numbers_of(nearest->row), stale ? "" : "Click to draw the picture with it.");
    if (clicked && !stale) use(nearest->row, state);
}

bool TechniqueChart::draw(const Ui& ui, const Scene& scene, ExplorerState& state, Status& status) {
    if (state.ray) {
        ImGui::TextWrapped(
            "A view ray without a scene has no picture to measure. Use the ray editor to go back to the scene.");
        return false;
    }
    const bool asked = draw_controls(ui, scene, state, status);
    if (measurement_.rows().empty()) {
        ImGui::TextWrapped(
            "%s", measurement_.busy()
                      ? "The first rows appear when their rounds are finished."
                      : "Time against error of every technique on this scene. Press measure. Then click on a "
                        "mark to draw the picture with that technique and its parameters, or set bounds on "
                        "error and bits to find the cheapest technique that meets them.");
        return false;
    }
    const bool stale = is_stale(state);
    if (stale) {
        ImGui::TextWrapped(
            "%s",
            fmt::format(
                "These rows were measured on {} at {}, with the order of submission at that time; press measure "
                "for rows of the current scene.",
                measurement_.scene(), size_text(measurement_.settings().size))
                .c_str());
        ui.record_widget_rect("chart.stale");
    } else {
        ImGui::TextDisabled("%s", fmt::format("{} configurations on {} at {}, the scene's own view",
                                              measurement_.rows().size(), measurement_.scene(),
                                              size_text(measurement_.settings().size))
                                      .c_str());
    }
    draw_chart(ui, stale, state);
    draw_bounds(ui);
    update_advice();  // with the current bounds
    draw_advice(ui, stale, state);
    return asked;
}

void TechniqueChart::write(const std::filesystem::path& path, const GlInfo& gl) const {
    ChartPlan plan;
    plan.scenes = {measurement_.scene()};
    plan.settings = measurement_.settings();
    if (const std::string content = measurement_.content(); content != BUILTIN_CONTENT)
        plan.contents = {content};
    RunTable table = {{}, chart_columns(), {}};
    for (std::size_t i = 0; i < measurement_.rows().size(); ++i) {
        plan.configurations.push_back(measurement_.configuration(i));
        table.rows.push_back(chart_line(measurement_.rows()[i]));
    }
    table.settings = chart_settings(plan, gl);
    const std::string kind = path.extension().string();
    if (kind == ".csv") return write_file(run_table_text(table), path);
    const Chart chart = chart_of(table, path.string());
    write_file(kind == ".html"  ? chart_to_html(chart, bounds_.metric)
               : kind == ".svg" ? chart_to_svg(chart, bounds_.metric)
                                : chart_to_markdown(chart, bounds_.metric),
               path);
}

}  // namespace momentscope::ui
