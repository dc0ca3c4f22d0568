#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/inspect/step_texts.hpp"
#include "ui/panels/moment_table.hpp"
#include "ui/panels/panels.hpp"
#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

namespace {

ImU32 blend(ImU32 from, ImU32 to, float share) {
    const ImVec4 a = ImGui::ColorConvertU32ToFloat4(from);
    const ImVec4 b = ImGui::ColorConvertU32ToFloat4(to);
    const auto mix = [share](float x, float y) { return x + share * (y - x); };
    return ImGui::ColorConvertFloat4ToU32({mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z), 1});
}

// The colour of a matrix entry from -1 to 1: one hue for each sign, stronger for greater values, none for 0.
ImU32 entry_color(const Ui& ui, double value) {
    const auto share = static_cast<float>(std::sqrt(std::min(std::abs(value), 1.0)));
    return blend(ui.colors.plot_background, value < 0 ? ui.colors.reconstruction : ui.colors.bounds,
                 0.85f * share);
}

std::string entry_text(const ComplexNumber& entry, bool complex) {
    if (!complex) return fmt::format("{:.4f}", entry.re);
    return fmt::format("{:.3f}{:+.3f}i", entry.re, entry.im);
}

void draw_matrix(const Ui& ui, const char* name, const MomentMatrix& matrix, bool complex) {
    const float width = complex ? 6.6f * em() : 3.8f * em();
    const float height = 1.5f * em();
    ImGui::BeginGroup();
    ImGui::TextDisabled("%s", name);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < matrix.order; ++i)
        for (std::size_t j = 0; j < matrix.order; ++j) {
            const ComplexNumber& entry = matrix.entry[i * matrix.order + j];
            const ImVec2 corner = {low.x + width * static_cast<float>(j),
                                   low.y + height * static_cast<float>(i)};
            list.AddRectFilled(corner, {corner.x + width - 1, corner.y + height - 1},
                               entry_color(ui, entry.re), 2);
            draw_text(list, {corner.x + 0.5f * width, corner.y + 0.5f * height}, {0.5f, 0.5f},
                      entry_text(entry, complex), ui.colors.text);
        }
    const auto order = static_cast<float>(matrix.order);
    ImGui::Dummy({width * order, height * order});
    const bool definite = matrix.smallest_eigenvalue > 0;
    if (definite)
        ImGui::Text("smallest eigenvalue %.2e, condition %.1e", matrix.smallest_eigenvalue, matrix.condition);
    else
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.colors.warning),
                           "smallest eigenvalue %.2e: not positive definite", matrix.smallest_eigenvalue);
    ImGui::EndGroup();
}

constexpr int KERNEL_SAMPLES = 240;
constexpr double KERNEL_REACH = 1.25;  // beyond the depth range, because a node may lie there

double kernel_depth(int sample) {
    return KERNEL_REACH * (2.0 * sample / (KERNEL_SAMPLES - 1) - 1);
}

// (z - z_f)^n K / K(z_f, z_f) over depth: it has the roots of the kernel polynomial and is finite everywhere.
// It is drawn as its signed n-th root, so that small bumps are visible beside large ones, and scaled to [-1,
// 1].
std::array<double, KERNEL_SAMPLES> kernel_samples(const Steps& steps) {
    std::array<double, KERNEL_SAMPLES> values{};
    double most = 1e-30;
    for (int i = 0; i < KERNEL_SAMPLES; ++i) {
        const double s = kernel_depth(i) - static_cast<double>(steps.query);
        double value = 0;
        for (std::size_t k = steps.kernel.size(); k-- > 1;)
            value = value * s + static_cast<double>(steps.kernel[k]);
        value = value * s + 1;
        values[static_cast<std::size_t>(i)] = value;
        most = std::max(most, std::abs(value));
    }
    const double root = 1.0 / static_cast<double>(steps.nodes.size());
    for (double& value : values) value = std::copysign(std::pow(std::abs(value) / most, root), value);
    return values;
}

void draw_kernel(const Ui& ui, const Steps& steps) {
    const ImVec2 size = {std::min(ImGui::GetContentRegionAvail().x, 34 * em()), 7 * em()};
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = {low.x + size.x, low.y + size.y};
    const float middle = 0.5f * (low.y + high.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ui.colors.plot_background, 3);
    const auto x_of = [&](double depth) {
        return low.x + static_cast<float>(0.5 + 0.5 * depth / KERNEL_REACH) * size.x;
    };
    list.AddLine({low.x, middle}, {high.x, middle}, ui.colors.axis);
    for (const double end : {-1.0, 1.0})
        list.AddLine({x_of(end), low.y}, {x_of(end), high.y}, ui.colors.grid);
    const auto values = kernel_samples(steps);
    std::vector<ImVec2> line;
    for (int i = 0; i < KERNEL_SAMPLES; ++i)
        line.push_back({x_of(kernel_depth(i)),
                        middle - static_cast<float>(values[static_cast<std::size_t>(i)]) * 0.44f * size.y});
    list.AddPolyline(line.data(), KERNEL_SAMPLES, ui.colors.reconstruction, 0, 0.13f * em());
    list.PushClipRect(low, high, true);
    for (const StepNode& node : steps.nodes)
        list.AddCircleFilled({x_of(static_cast<double>(node.depth)), middle}, 0.3f * em(), ui.colors.stems);
    const float query = x_of(static_cast<double>(steps.query));
    list.AddLine({query, low.y}, {query, high.y}, ui.colors.truth);
    draw_text(list, {query + 0.3f * em(), low.y + 0.2f * em()}, {0, 0}, "z_f", ui.colors.text);
    list.PopClipRect();
    ImGui::Dummy(size);
    ui.record_widget_rect("steps.kernel");
    tooltip(
        "The kernel polynomial over depth. The dots are its roots, the nodes of the canonical representation. "
        "The plot shows the n-th root of the polynomial, so that small bumps are visible.");
}

// Draws the nodes on the unit circle, and the wrapping zone as an arc.
void draw_circle(const Ui& ui, const Steps& steps) {
    const float radius = 4.2f * em();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 middle = {low.x + radius + 2.5f * em(), low.y + radius + 1.2f * em()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](double phase, float r) {
        return ImVec2(middle.x + r * static_cast<float>(std::cos(phase)),
                      middle.y - r * static_cast<float>(std::sin(phase)));
    };
    constexpr double PI = std::numbers::pi;
    const double end = 2 * PI - static_cast<double>(steps.parameters.theta);
    std::vector<ImVec2> arc;
    for (int i = 0; i <= 96; ++i) arc.push_back(at(end * i / 96, radius));
    list.AddPolyline(arc.data(), static_cast<int>(arc.size()), ui.colors.axis, 0, 0.12f * em());
    std::vector<ImVec2> zone;
    for (int i = 0; i <= 24; ++i) zone.push_back(at(end + (2 * PI - end) * i / 24, radius));
    list.AddPolyline(zone.data(), static_cast<int>(zone.size()), ui.colors.wrapping_zone, 0, 0.25f * em());
    const double per_depth = PI - 0.5 * static_cast<double>(steps.parameters.theta);
    const double query = (static_cast<double>(steps.query) + 1) * per_depth;
    const auto dot = [&](double phase, float weight, ImU32 color, const std::string& name) {
        list.AddCircleFilled(at(phase, radius), (0.2f + 0.5f * std::sqrt(std::max(weight, 0.0f))) * em(),
                             color);
        draw_text(list, at(phase, radius + 1.3f * em()), {0.5f, 0.5f}, name, ui.colors.text);
    };
    for (std::size_t l = 0; l < steps.nodes.size(); ++l)
        dot(steps.nodes[l].phase, steps.nodes[l].weight, ui.colors.stems, fmt::format("x{}", l + 1));
    dot(query, steps.query_weight, ui.colors.truth, "x(z_f)");
    ImGui::Dummy({2 * radius + 5 * em(), 2 * radius + 2.4f * em()});
    ui.record_widget_rect("steps.circle");
    tooltip(
        "Depths on the unit circle, from the near end at the right counter-clockwise. The thick arc is the wrapping zone. The "
        "dots are the nodes; larger dots stand for greater masses.");
}

void draw_figures(const Ui& ui, const Steps& steps, const std::string& title, bool circle) {
    const bool matrix = title.starts_with("3");
    if (matrix) {
        draw_matrix(ui, "before bias", steps.before, circle);
        const float needed = ImGui::GetItemRectSize().x + 2 * em();
        if (ImGui::GetItemRectMax().x + needed <
            ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
            ImGui::SameLine(0, 2 * em());
        draw_matrix(ui, "after bias", steps.after, circle);
    }
    if (title.starts_with("5") && !circle) draw_kernel(ui, steps);
    if (title.starts_with("6") && circle) draw_circle(ui, steps);
}

}  // namespace

void draw_steps_panel(const Ui& ui, Workspace& w) {
    const Measurement& m = w.measurement();
    if (!m.curve.technique->has_moments()) {
        ImGui::TextWrapped(
            "%s has no steps, because it does not reconstruct from moments. Choose a technique with moments.",
            m.curve.technique->name);
        return;
    }
    const Steps& steps = m.steps;
    if (steps.empty) {
        ImGui::TextWrapped("No transparent surface lies on this ray. Click on one in the scene.");
        return;
    }
    if (steps.parameters.textbook)
        ImGui::TextWrapped(
            "These are the steps of the robust solver. The picture is drawn with the textbook solver, which takes the same "
            "steps with fewer precautions.");
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted("0  Add up");
    ImGui::PopFont();
    ui.record_widget_rect("steps.0");
    ImGui::TextWrapped(
        "The first pass adds up what each fragment contributes: its absorbance a_l, times functions of its depth z_l. The sums are "
        "all that the pixel stores (Section 3.1).");
    if (!w.state.ray ||
        w.options.embedding.shown != Shown::window)  // otherwise it stands in place of the scene
        draw_moment_table(ui, w, ImGui::GetContentRegionAvail().x);
    ImGui::Spacing();
    const bool circle = m.curve.technique->on_circle();
    for (const StepText& step : step_texts(steps)) {
        ImGui::PushFont(bold_font());
        ImGui::TextUnformatted(step.title.c_str());
        ImGui::PopFont();
        ui.record_widget_rect("steps." + step.title.substr(0, 1));
        ImGui::TextWrapped("%s", step.sentence.c_str());
        draw_figures(ui, steps, step.title, circle);
        if (!step.title.starts_with("3")) {
            ImGui::Indent();
            ImGui::TextUnformatted(step.numbers.c_str());
            ImGui::Unindent();
        }
        ImGui::Spacing();
    }
}

}  // namespace momentscope::ui
