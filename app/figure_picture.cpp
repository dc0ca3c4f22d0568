#include "app/figure_picture.hpp"

#include <imgui.h>

#include <algorithm>

#include "app/gl_context.hpp"
#include "app/image_texture.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "ui/model/measurement.hpp"
#include "ui/model/selection.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope {

namespace {

constexpr int COLUMNS = 3;
const ImVec2 PLOT(560, 400);
const ImVec2 PICTURE(480, 270);

/// The content of one panel: a texture or a measured ray.
struct Drawn {
    const FigurePanel* panel;
    GlTexture texture;
    ui::ExplorerState state;
    ui::Measurement measurement;
    ui::PlotPanel plot;
};

Drawn drawn(const FigurePanel& panel, RenderSource& setups) {
    Drawn result = {&panel, {}, {}, {}, {}};
    if (!panel.plot) {
        result.texture = image_texture(setups.picture(panel.setup));
        return result;
    }
    ui::ExplorerState& state = result.state;
    state.technique = &require_technique(panel.setup.technique);
    state.parameters = values_with(panel.setup.settings);
    state.ray = panel.ray ? *panel.ray : setups.picked_ray(panel.setup);
    if (panel.transmittance) ui::set_quantity(state.plot, ui::Quantity::transmittance);
    state.plot.shown[static_cast<std::size_t>(ui::Series::stems)] = false;
    result.measurement.capture.ray = *state.ray;
    ui::measure_curves(result.measurement, state);
    ui::measure_query(result.measurement, state);
    return result;
}

void draw(const ui::Ui& ui, Drawn& one) {
    ImGui::BeginGroup();
    ImGui::TextUnformatted(one.panel->caption.c_str());
    if (one.panel->plot)
        one.plot.draw(ui, one.measurement, one.state, PLOT);
    else
        ImGui::Image(ui::texture_id(one.texture), PICTURE, {one.panel->part.x, one.panel->part.y},
                     {one.panel->part.z, one.panel->part.w});
    ImGui::EndGroup();
}

}  // namespace

void write_figure_picture(GuiSession& gui, const Figure& figure, RenderSource& setups,
                          const std::filesystem::path& path) {
    std::vector<Drawn> all;
    for (const FigurePanel& panel : figure.panels) all.push_back(drawn(panel, setups));
    ui::WidgetRects widget_rects;
    const ui::Ui ui{ui::palette(ui::ThemeKind::light), widget_rects};
    glm::ivec2 size = MAX_FIGURE_SIZE;
    for (int frame = 0; frame < 2; ++frame) {  // the first frame measures the size
        gui.begin_frame(size);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({static_cast<float>(size.x), static_cast<float>(size.y)});
        ImGui::Begin("figure", nullptr, ImGuiWindowFlags_NoDecoration);
        ImVec2 end(0, 0);
        for (std::size_t i = 0; i < all.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (i % COLUMNS != 0) ImGui::SameLine();
            draw(ui, all[i]);
            ImGui::PopID();
            end = {std::max(end.x, ImGui::GetItemRectMax().x), std::max(end.y, ImGui::GetItemRectMax().y)};
        }
        ImGui::End();
        gui.end_frame(size);
        if (frame == 0)
            size = glm::min(
                size, glm::ivec2(static_cast<int>(end.x + ui::em()), static_cast<int>(end.y + ui::em())));
    }
    write_png(read_window(size), size.x, size.y, path);
}

}  // namespace momentscope
