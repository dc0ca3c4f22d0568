#include "ui/tools/ray_editor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/image/image.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/ray/random_ray.hpp"
#include "core/ray/ray_json.hpp"
#include "core/ray/ray_presets.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "ui/model/selection.hpp"
#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

constexpr float MAX_OPACITY = 0.9999f;

// Maps depth and opacity to the screen and back.
struct EditorCanvas {
    Rect area;
    float x(float depth) const { return area.low.x + 0.5f * (depth + 1) * (area.high.x - area.low.x); }
    float y(float opacity) const { return area.high.y - opacity * (area.high.y - area.low.y); }
    float depth(ImVec2 at) const {
        return std::clamp(2 * (at.x - area.low.x) / (area.high.x - area.low.x) - 1, -1.0f, 1.0f);
    }
    float opacity(ImVec2 at) const {
        return std::clamp((area.high.y - at.y) / (area.high.y - area.low.y), 0.0f, MAX_OPACITY);
    }
};

namespace {

constexpr std::size_t MAX_HANDLES = 2000;  // more handles would cover each other

void place(Fragment& fragment, float depth, const DepthWarp& warp) {
    // Compute the depth from the view depth, as the shaders do, so that a saved ray comes back the same.
    fragment.view_depth = warp.has_view_depths() ? to_view_depth(depth, warp) : depth;
    fragment.depth = warp.has_view_depths() ? to_depth(fragment.view_depth, warp) : depth;
}

void draw_sources(const Ui& ui, const Measurement& m, ExplorerState& state) {
    ImGui::SetNextItemWidth(10 * em());
    const bool open = ImGui::BeginCombo("##preset", "start from ...", ImGuiComboFlags_HeightLargest);
    ui.record_widget_rect("editor.preset");
    tooltip("Replaces this ray by a ready-made one to experiment with; Ctrl+Z brings the old ray back.");
    if (open) {
        for (const RayPreset& preset : ray_presets()) {
            if (ImGui::Selectable(preset.name)) edit_ray(state, preset.make());
            ui.record_widget_rect(fmt::format("editor.preset.{}", preset.id));
            tooltip(preset.help);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    if (state.ray) {
        if (ImGui::Button("back to the scene")) leave_ray(state);
        ui.record_widget_rect("editor.leave");
        tooltip("Goes back to the scene and its picked pixel.");
    } else {
        if (ImGui::Button("edit this ray")) edit_ray(state, m.capture.ray);
        ui.record_widget_rect("editor.detach");
        tooltip("Copies the picked pixel's ray from the scene, so that you can move its fragments.");
    }
}

void draw_clipboard(const Ui& ui, const Measurement& m, ExplorerState& state, Status& status) {
    ImGui::SameLine();
    if (ImGui::Button("copy")) {
        ImGui::SetClipboardText(json_text(ray_to_json(m.capture.ray), 1).c_str());
        status.say("The ray was copied as JSON.");
    }
    ui.record_widget_rect("editor.copy");
    tooltip("Copies the ray as JSON.");
    ImGui::SameLine();
    if (ImGui::Button("paste")) {
        const char* text = ImGui::GetClipboardText();
        try {
            edit_ray(state, ray_from_json(text == nullptr ? "" : text));
        } catch (const Error& error) {
            status.say(error.what());
        }
    }
    ui.record_widget_rect("editor.paste");
    tooltip("Replaces this ray by the ray in the clipboard, which is read as JSON.",
            "File > Open view ray reads one from a file.");
}

void draw_swatches(const Ui& ui, const Measurement& m, const ExplorerState& state) {
    const PixelColors colors =
        pixel_colors(m.capture.ray, m.history, *m.curve.technique, m.curve.parameters, m.capture.behind);
    const auto swatch = [&](const char* name, const glm::vec3& color) {
        ImGui::ColorButton(name, display_color(color), ImGuiColorEditFlags_NoTooltip,
                           {2.2f * em(), 1.2f * em()});
        ImGui::SameLine();
        ImGui::Text("%s (%.3f, %.3f, %.3f)", name, static_cast<double>(color.r), static_cast<double>(color.g),
                    static_cast<double>(color.b));
    };
    swatch("truth", colors.truth);
    ui.record_widget_rect("editor.truth");
    tooltip("The pixel's colour, composited front to back over grey; linear RGB.");
    ImGui::SameLine(0, 1.5f * em());
    swatch(state.technique->id, colors.technique);
    ui.record_widget_rect("editor.technique");
    tooltip("The pixel's colour with the fragment weights of the technique; linear RGB.");
}

void draw_marked(const Ui& ui, ExplorerState& state) {
    if (!state.ray) return;
    if (!state.marked || *state.marked >= state.ray->fragments.size()) {
        ImGui::AlignTextToFramePadding();  // as high as the controls that are here otherwise
        ImGui::TextDisabled("Double-click to add a fragment; drag sideways for depth, up for opacity.");
        return;
    }
    Fragment fragment = state.ray->fragments[*state.marked];
    bool changed = false;
    float depth = fragment.depth;
    ImGui::SetNextItemWidth(8 * em());
    if (ImGui::DragFloat("##depth", &depth, 0.002f, -1, 1, "z = %.4f", ImGuiSliderFlags_AlwaysClamp)) {
        place(fragment, depth, state.ray->warp);
        changed = true;
    }
    ui.record_widget_rect("editor.depth");
    tooltip("Warped depth of the marked fragment in [−1, 1]. Drag, or double-click to type.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(8 * em());
    changed |= ImGui::DragFloat("##opacity", &fragment.opacity, 0.002f, 0, 1, "α_l = %.4f",
                                ImGuiSliderFlags_AlwaysClamp);
    ui.record_widget_rect("editor.opacity");
    tooltip("Opacity α_l of the marked fragment. Drag, or double-click to type.");
    ImGui::SameLine();
    changed |= ImGui::ColorEdit3("##color", &fragment.color.r,
                                 ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
    ui.record_widget_rect("editor.color");
    tooltip("Its colour, linear RGB.");
    ImGui::SameLine();
    if (ImGui::Button("delete")) return delete_marked(state);
    ui.record_widget_rect("editor.delete");
    tooltip("Removes the marked fragment from the ray.", "Delete");
    if (!changed) return;
    ViewRay ray = *state.ray;
    ray.fragments[*state.marked] = fragment;
    change_ray(state, std::move(ray));
}

std::size_t handle_count(const ViewRay& ray) {
    return std::min(ray.fragments.size(), MAX_HANDLES);
}

std::optional<std::size_t> handle_at(const EditorCanvas& canvas, const ViewRay& ray, ImVec2 at) {
    std::optional<std::size_t> nearest;
    float least = 0.8f * em();
    for (std::size_t i = 0; i < handle_count(ray); ++i) {
        const Fragment& fragment = ray.fragments[i];
        const float distance = std::hypot(canvas.x(fragment.depth) - at.x, canvas.y(fragment.opacity) - at.y);
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void draw_canvas_axes(const Ui& ui, const EditorCanvas& canvas) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto& [low, high] = canvas.area;
    list.AddRectFilled(low, high, ui.colors.plot_background, 3);
    for (const float opacity : {0.0f, 0.5f, 1.0f}) {
        list.AddLine({low.x, canvas.y(opacity)}, {high.x, canvas.y(opacity)}, ui.colors.grid);
        draw_text(list, {low.x - 0.3f * em(), canvas.y(opacity)}, {1, 0.5f}, fmt::format("{:g}", opacity),
                  ui.colors.text);
    }
    for (const float depth : {-1.0f, -0.5f, 0.0f, 0.5f, 1.0f}) {
        list.AddLine({canvas.x(depth), low.y}, {canvas.x(depth), high.y}, ui.colors.grid);
        draw_text(list, {canvas.x(depth), high.y + 0.15f * em()}, {0.5f, 0}, fmt::format("{:g}", depth),
                  ui.colors.text);
    }
    draw_text(list, {low.x + 0.3f * em(), low.y + 0.1f * em()}, {0, 0}, "opacity α_l over warped depth z",
              ui.colors.axis);
}

void draw_handles(const Ui& ui, const EditorCanvas& canvas, const ViewRay& ray,
                  std::optional<std::size_t> marked) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = handle_count(ray); i-- > 0;) {
        const Fragment& fragment = ray.fragments[i];
        const ImVec2 at = {canvas.x(fragment.depth), canvas.y(fragment.opacity)};
        const bool on = marked == i;
        list.AddLine({at.x, canvas.area.high.y}, at, ui.colors.axis, 0.1f * em());
        list.AddCircleFilled(at, 0.45f * em(), ImGui::ColorConvertFloat4ToU32(display_color(fragment.color)));
        list.AddCircle(at, (on ? 0.6f : 0.45f) * em(), on ? ui.colors.mark : ui.colors.text, 0,
                       (on ? 0.16f : 0.07f) * em());
        ui.widget_rects[fmt::format("editor.fragment.{}", i + 1)] = {{at.x - 2, at.y - 2},
                                                                     {at.x + 2, at.y + 2}};
    }
    const auto& [low, high] = canvas.area;
    if (ray.fragments.empty())
        draw_text(list, {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}, {0.5f, 0.5f},
                  "Double-click here to add a fragment.", ui.colors.text);
}

}  // namespace

// The ray as the mouse changed it in this frame; nullopt if it did not.
std::optional<ViewRay> RayEditor::edited(const EditorCanvas& canvas, const ViewRay& shown,
                                         ExplorerState& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::optional<std::size_t> near = handle_at(canvas, shown, mouse);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !near) {
        ViewRay ray = shown;
        ray.fragments.push_back(plain_fragment(0, canvas.opacity(mouse), ray.fragments.size()));
        place(ray.fragments.back(), canvas.depth(mouse), ray.warp);
        held_ = ray.fragments.size() - 1;
        return ray;
    }
    if (ImGui::IsItemActivated()) {
        held_ = near;
        mark(state, near);
    } else if (!ImGui::IsItemActive()) {
        held_.reset();
    } else if (held_ && *held_ < shown.fragments.size() &&
               ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.15f * em())) {
        ViewRay ray = shown;
        place(ray.fragments[*held_], canvas.depth(mouse), ray.warp);
        ray.fragments[*held_].opacity = canvas.opacity(mouse);
        return ray;
    }
    return std::nullopt;
}

void RayEditor::draw_canvas(const Ui& ui, const Measurement& m, ExplorerState& state) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size = {std::max(room.x, 1.0f), std::max(room.y - 0.3f * em(), 5 * em())};
    ImGui::InvisibleButton("canvas", size);
    ui.record_widget_rect("editor.canvas");
    const float pad = 0.9f * em();
    const EditorCanvas canvas = {
        {{low.x + 2.2f * em(), low.y + pad}, {low.x + size.x - pad, low.y + size.y - 1.4f * em()}}};
    if (canvas.area.empty()) return;
    ui.widget_rects["editor.area"] = canvas.area;
    const auto shown = [&]() -> const ViewRay& { return state.ray ? *state.ray : m.capture.ray; };
    if (std::optional<ViewRay> ray = edited(canvas, shown(), state)) {
        if (!state.ray)
            edit_ray(state, *std::move(ray));  // the first edit detaches the ray from the scene
        else
            change_ray(state, *std::move(ray));
        state.marked = held_;
    }
    draw_canvas_axes(ui, canvas);
    draw_handles(ui, canvas, shown(), state.marked);
}

void RayEditor::draw(const Ui& ui, const Measurement& m, ExplorerState& state, Status& status) {
    draw_sources(ui, m, state);
    draw_clipboard(ui, m, state, status);
    draw_swatches(ui, m, state);
    draw_marked(ui, state);
    draw_canvas(ui, m, state);
}

}  // namespace momentscope::ui
