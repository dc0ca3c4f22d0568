// headless_window.hpp -- the content of the real window without a display.
#pragma once
#include <memory>

#include "app/frame_log.hpp"
#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "ui/window/frame_need.hpp"

namespace momentscope {

class HeadlessWindow {
public:
    /// Throws Error if there is no GL, or if the first scene cannot be shown.
    HeadlessWindow(glm::ivec2 size, const ui::ExplorerState& state, const ui::WindowOptions& options,
                   FrameLog& log);

    /// Uses a context that is current and at least as large, and programs that are shared with other
    /// renderers.
    HeadlessWindow(std::shared_ptr<GlContext> context, std::shared_ptr<ProgramCache> programs,
                   glm::ivec2 size, const ui::ExplorerState& state, const ui::WindowOptions& options,
                   FrameLog& log);

    /// Makes one frame, a sixtieth of a second after the last one plus the time that passed. It is painted
    /// only if pixels() is called.
    void draw();

    /// Adds time before the next frame.
    void pass(float seconds) { passed_ += seconds; }

    /// Call this after input. Draws until no more frames are needed.
    void settle();

    /// Draws only the frames that are needed without input.
    void idle();

    /// The content of the window as sRGB RGBA bytes, from the top.
    std::vector<unsigned char> pixels() const;
    void write_png(const std::string& path) const;

    /// Sets the size from the next frame on, as if the window was resized. It cannot exceed the first size.
    void resize(glm::ivec2 size) { size_ = glm::min(size, most_); }

    /// Is the open step of the lesson done? False if no lesson is open.
    bool step_is_done() const;

    ui::Explorer& explorer() { return explorer_; }
    const ui::Explorer& explorer() const { return explorer_; }
    Renderer& renderer() { return renderer_; }
    glm::ivec2 size() const { return size_; }
    FrameLog& log() { return log_; }

private:
    glm::ivec2 size_, most_;
    std::shared_ptr<GlContext> context_;
    Renderer renderer_;
    GuiSession gui_;
    ui::Explorer explorer_;
    ui::FrameNeed need_;
    float own_scale_, scale_;  // of the options; as it is drawn
    float passed_ = 0;
    FrameLog& log_;
};

}  // namespace momentscope
