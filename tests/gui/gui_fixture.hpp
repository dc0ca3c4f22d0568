// gui_fixture.hpp -- the content of the real window, headless. Tests play events and check state and pixels.
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <memory>

#include "app/event_player.hpp"

namespace momentscope::test {

/// The GL context of all windows of the process. Creating it and linking its programs takes longer than most
/// tests.
struct SharedGl {
    static constexpr glm::ivec2 SIZE{3840, 2160};  // of the largest window
    std::shared_ptr<GlContext> context = make_headless_context(SIZE);
    std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>();
};

inline const SharedGl& shared_gl() {
    static const SharedGl gl;
    return gl;
}

class GuiTest : public testing::Test {
protected:
    explicit GuiTest(glm::ivec2 size = {1280, 800}) : size_(size) {}

    /// Opens the window on a scene and draws until nothing changes.
    ui::Explorer& open(const char* scene = "planes", const char* technique = "power6-32") {
        ui::ExplorerState state;
        state.scene = scene;
        state.technique = &require_technique(technique);
        return open(state);
    }
    ui::Explorer& open(const ui::ExplorerState& state) {
        window_.reset();  // its ImGui context must end before the next one is created
        window_ = std::make_unique<HeadlessWindow>(shared_gl().context, shared_gl().programs, size_, state,
                                                   ui::WindowOptions{1, false, most_milliseconds_}, log_);
        window_->settle();
        return window_->explorer();
    }

    ui::Explorer& explorer() { return window_->explorer(); }
    ui::Workspace& workspace() { return window_->explorer().workspace(); }
    const std::string& message() { return workspace().status.message; }
    const ui::ExplorerState& state() { return workspace().state; }
    const ui::Measurement& measurement() { return workspace().measurement(); }

    /// Plays events (docs/events.md), one per line.
    void play(const std::string& events) { EventPlayer(*window_).play(events); }
    void settle() { window_->settle(); }
    void draw() { window_->draw(); }

    std::vector<unsigned char> screen() { return window_->pixels(); }

    /// "X Y" of a pixel of the scene's picture, for events.
    std::string on_scene(glm::ivec2 pixel) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        return fmt::format("{} {}", rect.low.x + static_cast<float>(pixel.x) + 0.5f,
                           rect.low.y + static_cast<float>(pixel.y) + 0.5f);
    }

    /// The number of pixels in a control's rectangle that differ between two screens.
    long changed(const std::string& anchor, const std::vector<unsigned char>& before,
                 const std::vector<unsigned char>& after) {
        const ui::Rect rect = workspace().widget_rects.at(anchor);
        long count = 0;
        const int right = std::min(static_cast<int>(rect.high.x), size_.x);
        const int bottom = std::min(static_cast<int>(rect.high.y), size_.y);
        for (int y = std::max(static_cast<int>(rect.low.y), 0); y < bottom; ++y)
            for (int x = std::max(static_cast<int>(rect.low.x), 0); x < right; ++x) {
                const auto at = static_cast<std::ptrdiff_t>(4 * (y * size_.x + x));
                count += std::equal(before.begin() + at, before.begin() + at + 4, after.begin() + at) ? 0 : 1;
            }
        return count;
    }

    double most_milliseconds_ =
        std::numeric_limits<double>::infinity();  // limit for a picture while the mouse drags
    glm::ivec2 size_;
    FrameLog log_{""};
    std::unique_ptr<HeadlessWindow> window_;
};

}  // namespace momentscope::test
