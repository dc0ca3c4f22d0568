#include "app/stress_picture.hpp"

#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "core/report/stress_report.hpp"
#include "core/support/error.hpp"
#include "ui/widgets/stress_map.hpp"

namespace momentscope {

namespace {

constexpr float MAP_SCALE = 1.25f;
constexpr glm::ivec2 MAX_SIZE(4096, 2160);

// Draws the scale of colours for rates from 0 to 1.
void draw_scale(const ui::Ui& ui) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (const double rate : {0.0, 1e-4, 1e-3, 1e-2, 1e-1}) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const glm::vec3 color = failure_color(rate);
        draw->AddRectFilled(low, {low.x + 2 * ui::em(), low.y + ui::em()},
                            ImGui::ColorConvertFloat4ToU32(ImVec4(color.r, color.g, color.b, 1)), 2);
        ImGui::Dummy({2 * ui::em(), ui::em()});
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, ui.colors.text);
        ImGui::TextUnformatted(rate == 0.0 ? "0" : rate == 0.1 ? "≥ 10%" : rate_text(rate).c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine(0, 1.5f * ui::em());
    }
    ImGui::NewLine();
}

}  // namespace

void write_stress_picture(const std::vector<StressCell>& cells, const StressOptions& options,
                          const std::filesystem::path& path) {
    const auto context = make_headless_context(MAX_SIZE);
    GuiSession gui(nullptr, MAP_SCALE);
    ui::apply_style(ui::ThemeKind::light, MAP_SCALE);
    ui::WidgetRects widget_rects;
    const ui::Ui ui{ui::palette(ui::ThemeKind::light), widget_rects};
    glm::ivec2 size = MAX_SIZE;
    for (int frame = 0; frame < 2; ++frame) {  // the first frame measures the text
        gui.begin_frame(size);
        const ImVec2 map = ui::stress_map_size(cells);
        const float least = ImGui::CalcTextSize(stress_title(options).c_str()).x;
        size = glm::min(glm::ivec2(static_cast<int>(std::max(map.x, least) + 2 * ui::em()),
                                   static_cast<int>(map.y + 5.5f * ui::em())),
                        MAX_SIZE);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({static_cast<float>(size.x), static_cast<float>(size.y)});
        ImGui::Begin("stress", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::TextUnformatted(stress_title(options).c_str());
        ui::draw_stress_map(ui, cells);
        ImGui::Spacing();
        draw_scale(ui);
        ImGui::End();
        gui.end_frame(size);
    }
    write_png(read_window(size), size.x, size.y, path);
}

}  // namespace momentscope
