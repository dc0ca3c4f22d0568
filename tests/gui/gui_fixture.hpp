// gui_fixture.hpp -- the real window's content, headless: tests move the mouse and press keys, and look at
// state and pixels.
#pragma once
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "ui/explorer.hpp"

namespace momentscope::test {

class GuiTest : public testing::Test {
protected:
    explicit GuiTest(glm::ivec2 size = {1280, 800}) : size_(size) {}

    /// Opens the explorer and draws until the layout has settled.
    ui::Explorer& open(const char* scene, const char* technique) {
        ui::ExplorerState state;
        state.scene = scene;
        state.technique = &require_technique(technique);
        explorer_ = std::make_unique<ui::Explorer>(renderer_, state);
        draw(3);
        return *explorer_;
    }

    void draw(int frames = 1) {
        for (int i = 0; i < frames; ++i) {
            gui_.begin_frame(size_);
            explorer_->frame();
            gui_.end_frame(size_);
        }
    }

    void move(ImVec2 to) {
        ImGui::GetIO().MousePos = to;
        draw();
    }
    void press(int button) {
        ImGui::GetIO().MouseDown[button] = true;
        draw();
    }
    void release(int button) {
        ImGui::GetIO().MouseDown[button] = false;
        draw();
    }
    void click(ImVec2 at) {
        move(at);
        press(0);
        release(0);
    }
    void drag(ImVec2 from, ImVec2 to, int button) {
        move(from);
        press(button);
        for (int i = 1; i <= 4; ++i) {
            const float share = static_cast<float>(i) / 4;
            move({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
        }
        release(button);
    }
    void wheel(ImVec2 at, float notches) {
        move(at);
        ImGui::GetIO().MouseWheel = notches;
        draw();
    }
    void tap(ImGuiKey key) {
        ImGui::GetIO().KeysDown[key] = true;
        draw();
        ImGui::GetIO().KeysDown[key] = false;
        draw();
    }

    /// The screen position of a pixel of the scene's picture.
    ImVec2 on_scene(glm::ivec2 pixel) const {
        const ImVec2 corner = explorer_->scene_corner();
        return {corner.x + static_cast<float>(pixel.x) + 0.5f, corner.y + static_cast<float>(pixel.y) + 0.5f};
    }

    std::vector<unsigned char> screen() const { return read_framebuffer(size_); }

    glm::ivec2 size_;
    std::unique_ptr<GlContext> context_ = make_gl_context("osmesa", size_);
    Renderer renderer_;
    GuiSession gui_{nullptr, 1.0f};
    std::unique_ptr<ui::Explorer> explorer_;
};

}  // namespace momentscope::test
