#define GLFW_INCLUDE_NONE
#include "app/open_window.hpp"

#include <GLFW/glfw3.h>

#include "app/frame_log.hpp"
#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "app/last_words.hpp"
#include "app/lost_display.hpp"
#include "app/user_folder.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "core/support/error.hpp"
#include "ui/model/selection.hpp"
#include "ui/window/frame_need.hpp"
#include "ui/workspace/keeping.hpp"

namespace momentscope {

namespace {

// Switches between a window and the whole screen.
class FullScreen {
public:
    void toggle(GLFWwindow* window) {
        if (glfwGetWindowMonitor(window) != nullptr) {
            glfwSetWindowMonitor(window, nullptr, place_.x, place_.y, size_.x, size_.y, GLFW_DONT_CARE);
            return;
        }
        glfwGetWindowPos(window, &place_.x, &place_.y);
        glfwGetWindowSize(window, &size_.x, &size_.y);
        GLFWmonitor* monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
        if (mode != nullptr)
            glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

private:
    glm::ivec2 place_{0}, size_{0};  // of the window before
};

// A window with the explorer and the loop that draws when something has changed.
class OpenWindow {
public:
    explicit OpenWindow(const WindowStart& start)
        : pixel_(start.pixel),
          context_(make_window_context(start.size)),
          gui_(context_->window(), start.scale),
          explorer_(renderer_, start.state,
                    {.scale = start.scale,
                     .most_milliseconds = ui::DRAG_MILLISECONDS,
                     .before_long_picture =
                         [this] {
                             say_drawing();
                             return false;
                         },
                     .settings = ui::NEW_USER,
                     .host = {.keep = keep_for_user,
                              .kept = kept_for_user,
                              .toggle_fullscreen = [this] { full_screen_.toggle(context_->window()); }}}),
          own_scale_(start.scale),
          scale_(start.scale),
          log_(start.log),
          lost_display_([this] { return last_words(explorer_.workspace().state); }) {
        glfwSetWindowSizeLimits(context_->window(), 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
        explorer_.workspace().course = start.course;
        if (!start.problem.empty()) explorer_.workspace().status.say(start.problem);
    }

    void run() {
        while (glfwWindowShouldClose(context_->window()) == GLFW_FALSE) {
            if (is_visible() && need_.due(explorer_)) draw();
            take_events();
        }
        if (glfwGetWindowMonitor(context_->window()) == nullptr)
            explorer_.workspace().settings.window = window_size();
        ui::keep_changes(explorer_.workspace());
        log_.require_written();
    }

private:
    glm::ivec2 size() const {
        glm::ivec2 size;
        glfwGetFramebufferSize(context_->window(), &size.x, &size.y);
        return size;
    }

    // In the units of the display, as windows are made; size() is in pixels.
    glm::ivec2 window_size() const {
        glm::ivec2 size;
        glfwGetWindowSize(context_->window(), &size.x, &size.y);
        return size;
    }

    // False if the window is minimised.
    bool is_visible() const { return size().x > 0 && size().y > 0; }

    // Waits until the next frame is due at the latest. Every event, whenever it comes, requests frames.
    void take_events() {
        if (!is_visible() || !need_.due(explorer_))
            glfwWaitEvents();
        else if (!need_.settling() &&
                 (explorer_.workspace().scene.is_reading() || ui::has_background_work(explorer_.workspace())))
            glfwWaitEventsTimeout(0.05);
        else
            glfwPollEvents();
        if (gui_.input()->take_happened()) need_.input();
    }

    void draw() {
        const glm::ivec2 size = this->size();
        if (gui_.input()->waits()) need_.input();
        if (const auto path = gui_.input()->take_dropped()) explorer_.workspace().files.open_dropped(*path);
        if (const float scale = explorer_.wanted_scale(own_scale_); scale != scale_) {
            GuiSession::set_scale(scale_ = scale);
            explorer_.set_scale(scale);
        }
        gui_.begin_frame(size);
        explorer_.frame();
        gui_.end_frame(size);
        log_.frame(explorer_);
        for (const std::string& note : renderer_.programs()->take_notes()) log_.line(note);
        need_.drawn();
        if (!picked_ && !explorer_.workspace().scene.is_reading()) {
            pick_option(pixel_, explorer_);
            picked_ = true;
        }
        if (const auto path = explorer_.workspace().files.take_window_export())
            export_window(size, path->string());
        glfwSwapBuffers(context_->window());
    }

    // Shows the notice at once, in the middle of the frame that will take long.
    void say_drawing() {
        gui_.paint_over_last(size(), [this](ImDrawList& list) { explorer_.draw_waiting(list); });
        log_.line("drawing…");
        glfwSwapBuffers(context_->window());
    }

    void export_window(glm::ivec2 size, const std::string& path) {
        try {
            write_png(read_window(size), size.x, size.y, path);
            explorer_.workspace().files.window_written(path, explorer_.workspace());
        } catch (const Error& error) {
            explorer_.workspace().status.say(error.what());
        }
    }

    PixelOption pixel_;
    std::unique_ptr<GlContext> context_;
    Renderer renderer_;
    GuiSession gui_;
    FullScreen full_screen_;
    ui::Explorer explorer_;
    float own_scale_, scale_;  // of the command line; as it is drawn
    FrameLog log_;
    ui::FrameNeed need_;
    bool picked_ = false;
    LostDisplay lost_display_;
};

}  // namespace

void run_window(const WindowStart& start) {
    OpenWindow(start).run();
}

void pick_option(const PixelOption& pixel, ui::Explorer& explorer) {
    if (!pixel) return;
    const glm::ivec2 size = explorer.workspace().measurement().picture_size;
    explorer.workspace().state.picked = ui::fraction_of(pixel.within(size), size);
}

}  // namespace momentscope
