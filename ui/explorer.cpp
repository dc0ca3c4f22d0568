#include "ui/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/scene/camera.hpp"
#include "core/scene/scenes.hpp"
#include "ui/parameter_controls.hpp"
#include "ui/plot.hpp"
#include "ui/registry_combos.hpp"
#include "ui/theme.hpp"

namespace momentscope::ui {

namespace {

constexpr std::size_t PLOT_SAMPLES = 512;
constexpr float SCENE_SHARE = 0.58f;  // of the window's width
constexpr float PLOT_SHARE = 0.60f;   // of the right side's height

bool is_builtin_scene(const std::string& id) {
    return std::ranges::any_of(scene_entries(), [&](const SceneEntry& entry) { return id == entry.id; });
}

glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size) {
    return (glm::vec2(glm::clamp(pixel, glm::ivec2(0), size - 1)) + 0.5f) / glm::vec2(size);
}

}  // namespace

Explorer::Explorer(Renderer& renderer, ExplorerState state) : renderer_(renderer), state_(std::move(state)) {}

// A scene that cannot be loaded is reported, and the choice goes back to the one that is shown.
void Explorer::load_scene_if_changed() {
    if (state_.scene == scene_.id) return apply_opacity();
    try {
        Scene scene = load_scene(state_.scene, *state_.parameters[ParameterId::opacity]);
        scene.id = state_.scene;
        renderer_.set_scene(scene);
        if (!scene_.id.empty()) {  // the first camera and pixel are the caller's choice
            state_.camera.reset();
            state_.picked.reset();
        }
        scene_ = std::move(scene);
        shown_view_.technique = nullptr;
        message_.clear();
    } catch (const Error& error) {
        if (scene_.id.empty()) throw;
        message_ = error.what();
        state_.scene = scene_.id;
    }
}

// Opacity belongs to mesh files; built-in scenes bring their own.
void Explorer::apply_opacity() {
    if (is_builtin_scene(scene_.id)) return;
    const float opacity = *state_.parameters[ParameterId::opacity];
    bool changed = false;
    for (Object& object : scene_.objects) {
        changed |= !object.opaque() && object.opacity != opacity;
        if (!object.opaque()) object.opacity = opacity;
    }
    if (!changed) return;
    renderer_.set_scene(scene_);
    shown_view_.technique = nullptr;
}

glm::ivec2 Explorer::picked(glm::ivec2 size) const {
    if (!state_.picked) return picked_pixel(scene_, size);
    return glm::clamp(glm::ivec2(glm::floor(*state_.picked * glm::vec2(size))), glm::ivec2(0), size - 1);
}

void Explorer::update(glm::ivec2 size) {
    try {
        if (!state_.ray) return update_picture(size);
        update_ray();
    } catch (const Error& error) {
        if (result_.curve.technique == nullptr) throw;  // nothing good to go on showing
        message_ = error.what();
    }
}

void Explorer::update_ray() {
    const View view = {{}, {}, state_.technique, state_.parameters};
    if (first_stale_stage(shown_view_, view) == Stage::nothing) return;
    result_.capture = {*state_.ray, {}};
    update_curve();
    shown_view_ = view;
}

void Explorer::update_curve() {
    const ViewRay& ray = result_.capture.ray;
    result_.curve = sample_curve(ray, *state_.technique, state_.parameters, plot_depths(ray, PLOT_SAMPLES));
}

void Explorer::update_picture(glm::ivec2 size) {
    load_scene_if_changed();
    const View view = {state_.camera.value_or(scene_.camera), size, state_.technique, state_.parameters};
    const glm::ivec2 pixel = picked(size);
    const Stage stage = first_stale_stage(shown_view_, view);
    if (stage == Stage::nothing && pixel == result_.pixel) return;
    renderer_.render(view);
    // The fragments of a pixel depend on nothing that comes after the opaque pass.
    if (stage <= Stage::opaque || pixel != result_.pixel) result_.capture = renderer_.capture_pixel(pixel);
    update_curve();
    result_.pixel = pixel;
    result_.picture_size = size;
    shown_view_ = view;
    message_.clear();
}

void Explorer::frame() {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.Pos);
    ImGui::SetNextWindowSize(viewport.Size);
    ImGui::Begin("Momentscope", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    const float status_height = ImGui::GetTextLineHeightWithSpacing() + 4;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 scene_size = {std::max(std::floor(SCENE_SHARE * room.x), 1.0f),
                               std::max(std::floor(room.y - status_height), 1.0f)};
    scene_corner_ = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("scene", scene_size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    handle_scene_input();
    update({static_cast<int>(scene_size.x), static_cast<int>(scene_size.y)});
    draw_scene(scene_size);

    ImGui::SameLine();
    ImGui::BeginGroup();
    const ImVec2 plot_size = {ImGui::GetContentRegionAvail().x, std::floor(PLOT_SHARE * scene_size.y)};
    draw_plot(result_.capture.ray, result_.curve, ImGui::GetCursorScreenPos(), plot_size);
    ImGui::Dummy(plot_size);
    ImGui::BeginChild("controls", {0, scene_size.y - plot_size.y - ImGui::GetStyle().ItemSpacing.y});
    draw_controls();
    ImGui::EndChild();
    ImGui::EndGroup();
    draw_status();
    ImGui::End();
}

void Explorer::draw_scene(ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = {scene_corner_.x + size.x, scene_corner_.y + size.y};
    if (state_.ray) {
        list.AddRectFilled(scene_corner_, end, color::PLOT_BACKGROUND);
        list.AddText(
            {scene_corner_.x + 16, scene_corner_.y + 16}, color::TEXT,
            "A view ray from a file: it has a function, but no picture.\nChoose a scene to see one.");
        return;
    }
    const auto texture =
        reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(renderer_.display_texture()));
    list.PushClipRect(scene_corner_, end, true);
    list.AddImage(texture, scene_corner_, end, {0, 1}, {1, 0});  // GL's first row is the lowest
    draw_mark();
    list.PopClipRect();
}

void Explorer::draw_mark() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 mark = {scene_corner_.x + static_cast<float>(result_.pixel.x) + 0.5f,
                         scene_corner_.y + static_cast<float>(result_.pixel.y) + 0.5f};
    for (const auto& [tint, thickness] : {std::pair(color::MARK_EDGE, 3.5f), std::pair(color::MARK, 1.5f)}) {
        list.AddCircle(mark, 9, tint, 32, thickness);
        for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
            list.AddLine({mark.x + 5 * way.x, mark.y + 5 * way.y}, {mark.x + 14 * way.x, mark.y + 14 * way.y},
                         tint, thickness);
    }
}

void Explorer::handle_scene_input() {
    const ImGuiIO& io = ImGui::GetIO();
    if (state_.ray || result_.picture_size.x < 1) return;  // no picture to act on
    const glm::ivec2 size = result_.picture_size;
    Camera camera = state_.camera.value_or(scene_.camera);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        state_.picked = fraction_of(glm::ivec2(glm::floor(glm::vec2(io.MousePos.x - scene_corner_.x,
                                                                    io.MousePos.y - scene_corner_.y))),
                                    size);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0)) {
        constexpr float RADIANS_PER_PIXEL = 0.008f;
        constexpr float STEEPEST = 1.5f;  // short of the poles, where up would be undefined
        camera.azimuth -= RADIANS_PER_PIXEL * io.MouseDelta.x;
        camera.elevation =
            std::clamp(camera.elevation + RADIANS_PER_PIXEL * io.MouseDelta.y, -STEEPEST, STEEPEST);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        camera.distance = std::clamp(camera.distance * std::pow(0.9f, io.MouseWheel), 0.1f, 500.0f);
    if (!(camera == scene_.camera)) state_.camera = camera;
    if (io.WantTextInput || ImGui::IsAnyItemActive()) return;
    const struct {
        ImGuiKey key;
        glm::ivec2 step;
    } arrows[] = {{ImGuiKey_LeftArrow, {-1, 0}},
                  {ImGuiKey_RightArrow, {1, 0}},
                  {ImGuiKey_UpArrow, {0, -1}},
                  {ImGuiKey_DownArrow, {0, 1}}};
    for (const auto& arrow : arrows)
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(arrow.key)))
            state_.picked = fraction_of(picked(size) + arrow.step, size);
}

void Explorer::draw_controls() {
    const float label_width = 14.5f * ImGui::GetFontSize();
    const auto label = [&](const char* text) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text);
        ImGui::SameLine(label_width);
        ImGui::SetNextItemWidth(-1);
    };
    label("scene");
    if (draw_scene_combo(state_.scene)) state_.ray.reset();
    label("technique");
    draw_technique_combo(state_.technique);
    draw_parameter_controls(*state_.technique, state_.parameters);
    if (!is_builtin_scene(state_.scene))
        draw_parameter_control(parameter(ParameterId::opacity), 0, state_.parameters);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped("%s", state_.technique->description);
    ImGui::PopStyleColor();
}

void Explorer::draw_status() {
    const std::string memory = state_.technique->bits_per_pixel > 0
                                   ? fmt::format("{} bits per pixel", state_.technique->bits_per_pixel)
                                   : std::string("memory grows with the fragments");
    const std::string place = state_.ray ? std::string("view ray from a file")
                                         : fmt::format("pixel {}, {}", result_.pixel.x, result_.pixel.y);
    const std::string status =
        fmt::format("{}   fragments {}   total absorbance {:.4g}   {}", place,
                    result_.capture.ray.fragments.size(), result_.curve.total_absorbance, memory);
    if (message_.empty())
        ImGui::TextUnformatted(status.c_str());
    else
        ImGui::TextColored({0.95f, 0.62f, 0.2f, 1}, "%s", message_.c_str());
}

}  // namespace momentscope::ui
