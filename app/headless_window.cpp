#include "app/headless_window.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "core/support/error.hpp"

namespace momentscope {

HeadlessWindow::HeadlessWindow(glm::ivec2 size, const ui::ExplorerState& state,
                               const ui::WindowOptions& options, FrameLog& log)
    : HeadlessWindow(make_headless_context(size), nullptr, size, state, options, log) {}

HeadlessWindow::HeadlessWindow(std::shared_ptr<GlContext> context, std::shared_ptr<ProgramCache> programs,
                               glm::ivec2 size, const ui::ExplorerState& state,
                               const ui::WindowOptions& options, FrameLog& log)
    : size_(size),
      most_(size),
      context_(std::move(context)),
      renderer_(programs != nullptr ? std::move(programs) : std::make_shared<ProgramCache>()),
      gui_(nullptr, options.scale),
      explorer_(renderer_, state, options),
      own_scale_(options.scale),
      scale_(options.scale),
      log_(log) {}

void HeadlessWindow::draw() {
    if (const float scale = explorer_.wanted_scale(own_scale_); scale != scale_) {
        GuiSession::set_scale(scale_ = scale);
        explorer_.set_scale(scale);
    }
    gui_.begin_frame(size_, std::exchange(passed_, 0.0f) + 1.0f / 60);
    explorer_.frame();
    GuiSession::end_frame();
    log_.frame(explorer_);
    for (const std::string& note : renderer_.programs()->take_notes()) log_.line(note);
    need_.drawn();
    if (const auto path = explorer_.workspace().files.take_window_export()) {
        try {
            write_png(path->string());
            explorer_.workspace().files.window_written(*path, explorer_.workspace());
        } catch (const Error& error) {
            explorer_.workspace().status.say(error.what());
        }
    }
}

std::vector<unsigned char> HeadlessWindow::pixels() const {
    gui_.paint(size_);
    return read_window(size_);
}

void HeadlessWindow::settle() {
    need_.input();
    idle();
}

void HeadlessWindow::idle() {
    while (need_.due(explorer_)) {
        draw();
        if (explorer_.workspace().scene.is_reading() || ui::has_background_work(explorer_.workspace()))
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

bool HeadlessWindow::step_is_done() const {
    const ui::Workspace& w = explorer_.workspace();
    const auto open = w.course.open_step(w.state);
    return open && w.lesson.progress.of(open->lesson->id, open->step).done;
}

void HeadlessWindow::write_png(const std::string& path) const {
    momentscope::write_png(pixels(), size_.x, size_.y, path);
}

}  // namespace momentscope
