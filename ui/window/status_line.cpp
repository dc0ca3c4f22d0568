#include <fmt/format.h>

#include <algorithm>

#include "ui/window/parts.hpp"

namespace momentscope::ui {

namespace {

ImVec4 color_of(ImU32 tint) {
    return ImGui::ColorConvertU32ToFloat4(tint);
}

}  // namespace

void draw_status_line(const Ui& ui, Workspace& w) {
    if (!w.status.message.empty()) {
        const std::string shown = elided(w.status.message, ImGui::GetContentRegionAvail().x);
        ImGui::TextColored(color_of(ui.colors.warning), "%s", shown.c_str());
        ui.record_widget_rect("status");
        tooltip(w.status.message);
        return;
    }
    if (w.picked.empty()) return ImGui::TextUnformatted("Reading the first scene.");
    std::string status = w.state.ray
                             ? std::string("view ray without a scene")
                             : fmt::format("pixel {}, {}", w.measurement().pixel.x, w.measurement().pixel.y);
    status += fmt::format("   {}   absorbance {:.4g}",
                          fragment_count_text(w.measurement().capture.ray.fragments.size()),
                          w.measurement().curve.total_absorbance);
    if (w.options.show_times && !w.state.ray) {
        const PassTimes& t = w.picture.renderer().pass_times();
        status += fmt::format("   ms: opaque {:.1f}, first pass {:.1f}, second {:.1f}, composite {:.1f}",
                              t.opaque, t.moments, t.color, t.composite);
    }
    ImGui::TextUnformatted(status.c_str());
    ui.record_widget_rect("status");
    tooltip(
        "The picked pixel, what lies on its ray, and the time that the GL took for the last run of each pass.");
    std::string gl = w.gl.software ? fmt::format("no GPU: {}", w.gl.renderer) : w.gl.renderer;
    if (w.gl.can.language.rounding == Rounding::lost) gl = "rounds inexactly: " + gl;
    if (is_narrow()) gl.clear();
    ImGui::SameLine(0, 2 * em());
    gl = elided(gl, ImGui::GetContentRegionAvail().x);
    const float width = ImGui::CalcTextSize(gl.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(ImGui::GetContentRegionAvail().x - width, 0.0f));
    ImGui::TextDisabled("%s", gl.c_str());
    ui.record_widget_rect("status.gl");
    std::string missing = fmt::format("OpenGL {}, {}", w.gl.version, w.gl.renderer);
    for (const MissingFeature& feature : w.gl.missing)
        missing += fmt::format("\nmissing: {}; {}.", feature.feature, feature.consequence);
    if (w.gl.missing.empty()) missing += "\nNothing that Momentscope could use is missing.";
    tooltip(missing);
}

}  // namespace momentscope::ui
