#include "ui/picture/scene_panel.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/scene/camera.hpp"
#include "ui/model/camera_moves.hpp"
#include "ui/model/selection.hpp"
#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

namespace {

// Draws a crosshair that is visible on any background.
void draw_crosshair_mark(ImDrawList& list, ImVec2 at, const Palette& colors) {
    const float scale = em() / 15;
    for (const auto& [tint, thickness] : {std::pair(colors.mark_edge, 3.5f), std::pair(colors.mark, 1.5f)}) {
        list.AddCircle(at, 9 * scale, tint, 32, thickness * scale);
        for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
            list.AddLine({at.x + 5 * scale * way.x, at.y + 5 * scale * way.y},
                         {at.x + 14 * scale * way.x, at.y + 14 * scale * way.y}, tint, thickness * scale);
    }
}

void draw_pin_mark(ImDrawList& list, ImVec2 at, std::size_t number, const Palette& colors) {
    // Put the number beside the place, so that the crosshair of a picked pixel does not hide it.
    const float radius = 0.6f * em();
    const ImVec2 head = {at.x - 1.3f * em(), at.y - 1.3f * em()};
    list.AddLine(at, head, colors.mark_edge, 0.2f * em());
    list.AddCircleFilled(at, 0.2f * em(), colors.mark_edge);
    list.AddCircleFilled(head, radius + 1.5f, colors.mark_edge);
    list.AddCircleFilled(head, radius, colors.pin);
    draw_text(list, head, {0.5f, 0.5f}, std::to_string(number), colors.mark_edge);
}

void draw_failure_counts(ImDrawList& list, const Rect& area, const ScenePicture& picture, float above,
                         const Palette& colors) {
    const float pad = 0.8f * em();
    const std::string counts = picture.failures
                                   ? fmt::format("failed: {} pixels (hatched)   clamped: {} pixels (plain)",
                                                 picture.failures->failed, picture.failures->clamped)
                                   : std::string("no moments, so no reconstruction can fail");
    draw_label(list, {area.low.x + pad, area.high.y - pad - ImGui::GetTextLineHeight() - above}, counts,
               colors);
}

std::optional<glm::ivec2> parse_place(const std::string& text) {
    std::string spaced = text;
    std::ranges::replace(spaced, ',', ' ');
    std::istringstream stream(spaced);
    glm::ivec2 pixel;
    std::string rest;
    if (!(stream >> pixel.x >> pixel.y) || stream >> rest) return std::nullopt;
    return pixel;
}

}  // namespace

void ScenePanel::draw_tools(const Ui& ui, const Measurement& m, const ScenePicture& picture,
                            ExplorerState& state, Status& status) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const auto next = [&](const char* label) { flow(button_width(label), right, 0.2f * em()); };
    const auto explain = [&](const char* anchor, const char* help, const char* key) {
        ui.record_widget_rect(anchor);
        tooltip(help, key);
    };
    if (ImGui::Button("reset view")) reset_camera(state);
    explain("scene.reset", "Returns to the scene's own camera.", "Home");
    next("views ▾");
    if (ImGui::Button("views ▾")) ImGui::OpenPopup("views");
    explain("scene.views", "Looks from a named direction.", "");
    if (ImGui::BeginPopup("views")) {
        for (const NamedView& view : named_views())
            if (ImGui::Selectable(view.name))
                state.camera = looking_from(state.camera.value_or(picture.scene_camera), view);
        ImGui::EndPopup();
    }
    next("lens");
    if (toggle_button("lens", state.lens)) state.lens = !state.lens;
    explain("scene.lens", "Magnifies the pixels around the picked one and shows their values.", "L");
    next("failures");
    if (toggle_button("failures", state.failures)) state.failures = !state.failures;
    explain(
        "scene.failures",
        "Marks pixels whose reconstruction failed (hatched), for example because the matrix of moments was "
        "singular in floats, and pixels where a sum left [0, 1] and was clamped (plain).",
        "O");
    next("flip");
    ImGui::Button("flip");
    flip_held_ = ImGui::IsItemActive();
    explain("scene.flip", "Shows the picture of the reference while the button is held.", "G, held");
    next("wipe");
    if (toggle_button("wipe", state.compare.mode == CompareMode::wipe))
        toggle(state.compare, CompareMode::wipe);
    explain("scene.wipe", "Shows the reference and the picture side by side; drag the line between them.",
            "W");
    const float width = 6.5f * em();
    flow(width, right, 0.2f * em());
    ImGui::SetNextItemWidth(std::max(std::min(width, ImGui::GetContentRegionAvail().x), 20.0f));
    draw_go_to(m.picture_size, state, status);
    explain("scene.goto", "Type the column and the row of a pixel and press Enter.", "Ctrl+G");
}

void ScenePanel::draw_go_to(glm::ivec2 size, ExplorerState& state, Status& status) {
    if (focus_go_to_) ImGui::SetKeyboardFocusHere();
    focus_go_to_ = false;
    std::string typed;  // ImGui keeps the typed text until Enter; each entry starts empty
    if (!ImGui::InputTextWithHint("##goto", "go to x, y", &typed, ImGuiInputTextFlags_EnterReturnsTrue))
        return;
    const auto place = parse_place(typed);
    if (place && glm::all(glm::greaterThanEqual(*place, glm::ivec2(0))) &&
        glm::all(glm::lessThan(*place, size))) {
        pick(state, fraction_of(*place, size));
    } else {
        status.say(fmt::format("'{}' is not a pixel of the picture; type two numbers from 0, 0 to {}, {}.",
                               typed, size.x - 1, size.y - 1));
    }
}

glm::ivec2 ScenePanel::draw_controls(const Ui& ui, const Measurement& m, const ScenePicture& picture,
                                     ExplorerState& state, ImVec2 size, bool tools, Status& status) {
    const float top = ImGui::GetCursorScreenPos().y;
    ImGui::PushID("scene panel");
    if (tools) draw_tools(ui, m, picture, state, status);
    list_ = ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 extent = {std::max(std::floor(size.x), 1.0f),
                           std::max(std::floor(size.y - (corner.y - top)), 1.0f)};
    ImGui::InvisibleButton("scene", extent,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui.record_widget_rect("scene");
    handle_mouse(ui, m, picture, state);
    ImGui::PopID();
    return {static_cast<int>(extent.x), static_cast<int>(extent.y)};
}

// The action that a press of the left button begins continues until the button is released.
void ScenePanel::handle_left(const Ui& ui, const Measurement& m, const ScenePicture& picture,
                             ExplorerState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const Rect area = ui.widget_rects["scene"];
    bool on_divider = false;
    if (picture.beside != 0) {
        const Rect divider = divider_area(area, state.compare);
        ui.widget_rects["scene.divider"] = divider;
        on_divider =
            io.MousePos.x >= divider.low.x && io.MousePos.x < divider.high.x && ImGui::IsItemHovered();
    }
    const glm::vec2 at(io.MousePos.x - area.low.x, io.MousePos.y - area.low.y);
    const glm::ivec2 pixel(glm::floor(at));
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        drag_ = on_divider ? Drag::divider : io.KeyShift ? Drag::region : Drag::pick;
        drag_from_ = pixel;
    }
    if (on_divider || drag_ == Drag::divider) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        drag_ = Drag::none;
    } else if (drag_ == Drag::divider) {
        state.compare.divider = std::clamp(at.x / (area.high.x - area.low.x), MIN_DIVIDER, MAX_DIVIDER);
    } else if (drag_ == Drag::pick) {
        pick(state, fraction_of(pixel, m.picture_size));
    } else if (drag_ == Drag::region) {
        const glm::ivec2 way = glm::abs(pixel - drag_from_);
        if (way.x + way.y == 0) {  // a click removes the region
            forget_region(state.compare);
        } else {
            state.compare.region = region_between(drag_from_, pixel, m.picture_size);
            state.panel = Panel::compare;  // this panel shows its numbers
        }
    }
}

void ScenePanel::handle_mouse(const Ui& ui, const Measurement& m, const ScenePicture& picture,
                              ExplorerState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (state.ray || m.picture_size.x < 1) return;  // there is no picture to act on
    handle_left(ui, m, picture, state);
    Camera camera = state.camera.value_or(picture.scene_camera);
    const bool active = ImGui::IsItemActive();
    const glm::vec2 moved_by(io.MouseDelta.x, io.MouseDelta.y);
    const bool moved = moved_by != glm::vec2(0);
    if (active && moved && ImGui::IsMouseDown(ImGuiMouseButton_Right)) camera = orbited(camera, moved_by);
    if (active && moved && ImGui::IsMouseDown(ImGuiMouseButton_Middle))
        camera = panned(camera, moved_by, m.picture_size);
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        if (io.KeyCtrl && state.lens)
            state.lens_zoom = zoomed(state.lens_zoom, io.MouseWheel > 0 ? 1 : -1);
        else
            camera = zoomed(camera, io.MouseWheel);
    }
    if (!(camera == state.camera.value_or(picture.scene_camera))) state.camera = camera;
}

void ScenePanel::draw_picture(const Ui& ui, const Measurement& m, const ScenePicture& picture,
                              const ExplorerState& state) const {
    ImDrawList& list = *list_;
    const Rect area = ui.widget_rects["scene"];
    const float pad = 0.8f * em();
    if (picture.texture == 0) return list.AddRectFilled(area.low, area.high, ui.colors.plot_background);
    list.PushClipRect(area.low, area.high, true);
    // The first row in GL is the lowest. While another scene is read, the last picture may have another size.
    const auto draw_part = [&](unsigned name, float from, float to) {
        const float width = area.high.x - area.low.x;
        if (name == 0) return;
        list.AddImage(texture_id(name), {area.low.x + from * width, area.low.y},
                      {area.low.x + to * width, area.high.y}, {from, 1}, {to, 0});
    };
    const CompareState& compare = state.compare;
    const bool wipe = picture.beside != 0;
    const float own_from = wipe && !compare.swapped ? compare.divider : 0;
    const float own_to = wipe && compare.swapped ? compare.divider : 1;
    draw_part(picture.texture, own_from, own_to);
    draw_part(picture.overlay, own_from, own_to);
    draw_part(picture.beside, compare.swapped ? compare.divider : 0, compare.swapped ? 1 : compare.divider);
    const auto place = [&](glm::ivec2 pixel) {
        return ImVec2(area.low.x + static_cast<float>(pixel.x) + 0.5f,
                      area.low.y + static_cast<float>(pixel.y) + 0.5f);
    };
    for (std::size_t i = 0; i < m.pins.size(); ++i)
        draw_pin_mark(list, place(m.pins[i].pixel), i + 1, ui.colors);
    draw_crosshair_mark(list, place(m.pixel), ui.colors);
    if (compare.region) draw_region(list, area, *compare.region, ui.colors);
    if (wipe) draw_wipe(list, area, state, ui.colors);
    const float lens = draw_lens(list, area, picture.lens, state.lens_zoom, m.pixel, ui.colors);
    if (!picture.title.empty())
        draw_label(list, {area.low.x + pad, area.low.y + pad}, picture.title, ui.colors);
    if (picture.legend) draw_color_legend(list, area, *picture.legend, ui.colors);
    if (state.failures) draw_failure_counts(list, area, picture, lens, ui.colors);
    list.PopClipRect();
}

}  // namespace momentscope::ui
