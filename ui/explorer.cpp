#include "ui/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/scene/scenes.hpp"
#include "ui/parameter_controls.hpp"
#include "ui/plot.hpp"
#include "ui/theme.hpp"

namespace momentscope::ui {

namespace {

constexpr std::size_t PLOT_SAMPLES = 512;
constexpr float SCENE_SHARE = 0.58F;   // of the window's width
constexpr float PLOT_SHARE = 0.60F;    // of the right side's height

glm::ivec2 pixel_of(glm::vec2 fraction, glm::ivec2 size) {
    return glm::clamp(glm::ivec2(glm::floor(fraction * glm::vec2(size))), glm::ivec2(0), size - 1);
}

glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size) {
    return (glm::vec2(glm::clamp(pixel, glm::ivec2(0), size - 1)) + 0.5F) / glm::vec2(size);
}

}  // namespace

Explorer::Explorer(Renderer& renderer, ExplorerState state) : renderer_(renderer), state_(std::move(state)) {}

// A scene that cannot be loaded is reported, and the choice goes back to the one that is shown.
void Explorer::load_scene_if_changed() {
    const std::optional<float> opacity = state_.parameters[ParameterId::opacity];
    if (state_.scene == shown_scene_ && opacity == shown_opacity_) return;
    try {
        const Scene scene = load_scene(state_.scene, opacity.value_or(0.4F));
        if (state_.scene != shown_scene_ && !shown_scene_.empty()) {   // first: the caller chose camera and pixel
            state_.camera = scene.camera;
            state_.picked = scene.picked;
        }
        renderer_.set_scene(scene);
        shown_scene_ = state_.scene;
        shown_opacity_ = opacity;
        shown_view_.technique = nullptr;
        message_.clear();
    } catch (const Error& error) {
        if (shown_scene_.empty()) throw;
        message_ = error.what();
        state_.scene = shown_scene_;
    }
}

void Explorer::update(glm::ivec2 size) {
    load_scene_if_changed();
    const View view = {state_.camera, size, state_.technique, state_.parameters};
    const Stage stage = shown_view_.technique == nullptr ? Stage::opaque : first_stale_stage(shown_view_, view);
    const glm::ivec2 pixel = pixel_of(state_.picked, size);
    if (stage == Stage::nothing && captured_ && pixel == result_.pixel) return;
    try {
        renderer_.render(view);
        shown_view_ = view;
        result_.pixel = pixel;
        result_.picture_size = size;
        result_.capture = renderer_.capture_pixel(pixel);
        captured_ = true;
        result_.curve = sample_curve(result_.capture.ray, *state_.technique, state_.parameters,
                                     plot_depths(result_.capture.ray, PLOT_SAMPLES));
    } catch (const Error& error) {
        message_ = error.what();
    }
}

void Explorer::frame() {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.Pos);
    ImGui::SetNextWindowSize(viewport.Size);
    ImGui::Begin("Momentscope", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse);
    const float status_height = ImGui::GetTextLineHeightWithSpacing() + 4;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 scene_size = {std::max(std::floor(SCENE_SHARE * room.x), 1.0F),
                               std::max(std::floor(room.y - status_height), 1.0F)};
    scene_corner_ = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("scene", scene_size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
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
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(renderer_.display_texture()));
    list.PushClipRect(scene_corner_, end, true);
    list.AddImage(texture, scene_corner_, end, {0, 1}, {1, 0});   // GL's first row is the lowest
    const ImVec2 mark = {scene_corner_.x + static_cast<float>(result_.pixel.x) + 0.5F,
                         scene_corner_.y + static_cast<float>(result_.pixel.y) + 0.5F};
    for (const auto& [tint, thickness] : {std::pair(color::MARK_EDGE, 3.5F), std::pair(color::MARK, 1.5F)}) {
        list.AddCircle(mark, 9, tint, 32, thickness);
        for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
            list.AddLine({mark.x + 5 * way.x, mark.y + 5 * way.y}, {mark.x + 14 * way.x, mark.y + 14 * way.y}, tint,
                         thickness);
    }
    list.PopClipRect();
}

void Explorer::handle_scene_input() {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::ivec2 size = glm::max(result_.picture_size, 1);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        state_.picked = fraction_of(glm::ivec2(glm::floor(glm::vec2(io.MousePos.x - scene_corner_.x,
                                                                    io.MousePos.y - scene_corner_.y))), size);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0)) {
        constexpr float RADIANS_PER_PIXEL = 0.008F;
        constexpr float STEEPEST = 1.5F;   // short of the poles, where up would be undefined
        state_.camera.azimuth -= RADIANS_PER_PIXEL * io.MouseDelta.x;
        state_.camera.elevation =
            std::clamp(state_.camera.elevation + RADIANS_PER_PIXEL * io.MouseDelta.y, -STEEPEST, STEEPEST);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        state_.camera.distance = std::clamp(state_.camera.distance * std::pow(0.9F, io.MouseWheel), 0.1F, 500.0F);
    if (io.WantTextInput || ImGui::IsAnyItemActive()) return;
    const struct {
        ImGuiKey key;
        glm::ivec2 step;
    } arrows[] = {{ImGuiKey_LeftArrow, {-1, 0}}, {ImGuiKey_RightArrow, {1, 0}}, {ImGuiKey_UpArrow, {0, -1}},
                  {ImGuiKey_DownArrow, {0, 1}}};
    for (const auto& arrow : arrows)
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(arrow.key)))
            state_.picked = fraction_of(pixel_of(state_.picked, size) + arrow.step, size);
}

void Explorer::draw_technique_combo() {
    if (!ImGui::BeginCombo("##technique", fmt::format("{} ({})", state_.technique->name, state_.technique->id).c_str()))
        return;
    for (const Technique& technique : techniques()) {
        if (ImGui::Selectable(fmt::format("{} ({})", technique.name, technique.id).c_str(),
                              &technique == state_.technique))
            state_.technique = &technique;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", technique.source);
    }
    ImGui::EndCombo();
}

void Explorer::draw_scene_combo() {
    if (!ImGui::BeginCombo("##scene", state_.scene.c_str())) return;
    for (const SceneEntry& entry : scene_entries()) {
        if (ImGui::Selectable(entry.id, state_.scene == entry.id)) state_.scene = entry.id;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.description);
    }
    ImGui::EndCombo();
}

void Explorer::draw_controls() {
    const float label_width = 14.5F * ImGui::GetFontSize();
    const auto label = [&](const char* text) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text);
        ImGui::SameLine(label_width);
        ImGui::SetNextItemWidth(-1);
    };
    label("scene");
    draw_scene_combo();
    label("technique");
    draw_technique_combo();
    draw_parameter_controls(*state_.technique, state_.parameters);
    const bool is_mesh_file = std::ranges::none_of(scene_entries(), [&](const SceneEntry& entry) { return state_.scene == entry.id; });
    if (is_mesh_file) draw_parameter_control(parameter(ParameterId::opacity), 0, state_.parameters);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped("%s", state_.technique->description);
    ImGui::PopStyleColor();
}

void Explorer::draw_status() {
    const std::string memory = state_.technique->bits_per_pixel > 0
                                   ? fmt::format("{} bits per pixel", state_.technique->bits_per_pixel)
                                   : std::string("memory grows with the fragments");
    const std::string status =
        fmt::format("pixel {}, {}   fragments {}   total absorbance {:.4g}   {}", result_.pixel.x, result_.pixel.y,
                    result_.capture.ray.fragments.size(), result_.curve.total_absorbance, memory);
    if (message_.empty())
        ImGui::TextUnformatted(status.c_str());
    else
        ImGui::TextColored({0.95F, 0.62F, 0.2F, 1}, "%s", message_.c_str());
}

}  // namespace momentscope::ui
