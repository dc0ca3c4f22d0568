// headless_window.hpp -- the real window's content without a display.
#pragma once
#include <memory>

#include "app/frame_log.hpp"
#include "app/frame_need.hpp"
#include "app/gl_context.hpp"
#include "app/gui_session.hpp"

namespace momentscope {

class HeadlessWindow {
public:
    /// Throws Error when there is no GL, or when the first scene cannot be shown.
    HeadlessWindow(glm::ivec2 size, const ui::ExplorerState& state, ui::ExplorerOptions options,
                   FrameLog& log);

    /// In a context that is current and at least that large, and whose programs are shared with other
    /// renderers.
    HeadlessWindow(std::shared_ptr<GlContext> context, std::shared_ptr<ProgramCache> programs,
                   glm::ivec2 size, const ui::ExplorerState& state, ui::ExplorerOptions options,
                   FrameLog& log);

    /// Makes one frame, a sixtieth of a second after the last one and whatever passed. It is painted when
    /// somebody asks for its pixels.
    void draw();

    /// Lets time pass before the next frame.
    void pass(float seconds) { passed_ += seconds; }

    /// Tells that there was input, and draws until no frame is needed any more.
    void settle();

    /// Draws only the frames that are needed without input.
    void idle();

    /// The window's content as sRGB RGBA bytes, from the top.
    std::vector<unsigned char> pixels() const;
    void write_png(const std::string& path) const;

    /// Another size from the next frame on, as when a window is resized. Not greater than the first.
    void resize(glm::ivec2 size) { size_ = glm::min(size, most_); }

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
    FrameNeed need_;
    float passed_ = 0;
    FrameLog& log_;
};

}  // namespace momentscope
