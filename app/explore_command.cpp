#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/event_player.hpp"
#include "app/last_words.hpp"
#include "app/lost_display.hpp"
#include "app/output_conflicts.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/image/image.hpp"
#include "core/output_file.hpp"
#include "core/ray/ray_json.hpp"
#include "ui/session.hpp"

namespace momentscope {

namespace {

// What else was typed goes over it.
ui::ExplorerState state_of_session(const Options& options) {
    ui::Session session = ui::read_session_file(options.session);
    if (!session.ignored.empty())
        warn(fmt::format("The session has what this version does not know: {}.",
                         fmt::join(session.ignored, ", ")));
    session.state.parameters = parse_parameters(options, session.state.parameters);
    return session.state;
}

ui::ExplorerState state_of_options(const Options& options) {
    ui::ExplorerState state;
    state.parameters = parse_parameters(options);
    const auto techniques = parse_techniques(options, "power6-32");
    state.technique = techniques.front();
    state.compared.assign(techniques.begin() + 1, techniques.end());
    state.scene = options.scene;
    if (!options.ray.empty()) state.ray = read_ray_file(options.ray);
    return state;
}

ui::ExplorerState initial_state(const Options& options) {
    ui::ExplorerState state = options.session.empty() ? state_of_options(options) : state_of_session(options);
    if (!options.reference.empty()) {
        state.compare.reference = &require_technique(options.reference);
        state.panel = ui::Panel::compare;  // where one sees that it was chosen
    }
    if (!options.theme.empty())
        state.theme = options.theme == "light" ? ui::ThemeKind::light : ui::ThemeKind::dark;
    return state;
}

// --pixel counts in the scene's picture, whose size only a drawn frame knows.
void pick_option(const Options& options, ui::Explorer& explorer) {
    if (options.pixel.empty()) return;
    const glm::ivec2 size = explorer.measurement().picture_size;
    explorer.state().picked = ui::fraction_of(parse_pixel(options.pixel, size), size);
}

void explore_headless(const Options& options, glm::ivec2 size, float scale) {
    if (options.screenshot.empty() && options.events.empty())
        throw Error("--headless draws into a file; add --screenshot FILE.png, or --events FILE.");
    if (!options.screenshot.empty()) {
        require_writable(options.screenshot);
        if (std::filesystem::path(options.screenshot).extension() != ".png")
            throw Error(fmt::format("A screenshot is a .png; '{}' is not.", options.screenshot));
    }
    FrameLog log(options.log);
    HeadlessWindow window(size, initial_state(options), {.scale = scale, .show_times = false}, log);
    window.settle();
    pick_option(options, window.explorer());
    window.settle();
    const std::string warning = window.explorer().warning();
    if (!warning.empty()) warn(warning);
    const std::string& message = window.explorer().message();
    if (!message.empty() && message != warning) throw Error(message);
    if (!options.events.empty()) EventPlayer(window, files_of(options)).play_file(options.events);
    if (!options.screenshot.empty()) window.write_png(options.screenshot);
    log.require_written();
}

// A window, the explorer in it, and the loop that draws when there is something new to see.
class OpenWindow {
public:
    OpenWindow(const Options& options, glm::ivec2 size, float scale)
        : options_(options),
          context_(make_gl_context("glfw", size)),
          gui_(context_->window(), scale),
          explorer_(renderer_, initial_state(options),
                    {.scale = scale,
                     .most_milliseconds = ui::DRAG_MILLISECONDS,
                     .before_long_picture = [this] { say_drawing(); }}),
          log_(options.log),
          lost_display_([this] { return last_words(explorer_.state()); }) {
        glfwSetWindowSizeLimits(context_->window(), 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    }

    void run() {
        while (glfwWindowShouldClose(context_->window()) == GLFW_FALSE) {
            if (is_visible() && need_.due(explorer_)) draw();
            take_events();
        }
        log_.require_written();
    }

private:
    glm::ivec2 size() const {
        glm::ivec2 size;
        glfwGetFramebufferSize(context_->window(), &size.x, &size.y);
        return size;
    }

    // False while it is minimised.
    bool is_visible() const { return size().x > 0 && size().y > 0; }

    // Waits for no longer than until the next frame is due. Whatever happens, whenever it is asked for, asks
    // for frames.
    void take_events() {
        if (!is_visible() || !need_.due(explorer_))
            glfwWaitEvents();
        else if (!need_.settling() && (explorer_.is_loading_scene() || explorer_.has_background_work()))
            glfwWaitEventsTimeout(0.05);
        else
            glfwPollEvents();
        if (gui_.input()->take_happened()) need_.input();
    }

    void draw() {
        const glm::ivec2 size = this->size();
        if (gui_.input()->waits()) need_.input();
        gui_.begin_frame(size);
        explorer_.frame();
        gui_.end_frame(size);
        log_.frame(explorer_);
        for (const std::string& note : renderer_.programs()->take_notes()) log_.line(note);
        need_.drawn();
        if (!picked_ && !explorer_.is_loading_scene()) {
            pick_option(options_, explorer_);
            picked_ = true;
        }
        if (const auto path = explorer_.take_window_export()) export_window(size, path->string());
        glfwSwapBuffers(context_->window());
    }

    // Shown at once, in the midst of the frame that will take long.
    void say_drawing() {
        gui_.paint_over_last(size(), [this](ImDrawList& list) { explorer_.draw_waiting(list); });
        log_.line("drawing…");
        glfwSwapBuffers(context_->window());
    }

    void export_window(glm::ivec2 size, const std::string& path) {
        try {
            write_png(read_framebuffer(size), size.x, size.y, path);
            explorer_.say(fmt::format("Written to {}.", path));
        } catch (const Error& error) {
            explorer_.say(error.what());
        }
    }

    const Options& options_;
    std::unique_ptr<GlContext> context_;
    Renderer renderer_;
    GuiSession gui_;
    ui::Explorer explorer_;
    FrameLog log_;
    FrameNeed need_;
    bool picked_ = false;
    LostDisplay lost_display_;
};

}  // namespace

void run_explore(const Options& options) {
    const glm::ivec2 size = parse_size(options.size.empty() ? "1280x800" : options.size);
    const float scale = parse_scale(options.ui_scale);
    if (!options.theme.empty() && options.theme != "dark" && options.theme != "light")
        throw Error(fmt::format("There is no theme '{}'; use dark or light.", options.theme));
    if (options.headless) return explore_headless(options, size, scale);
    if (!options.screenshot.empty() || !options.events.empty())
        throw Error("--screenshot and --events need --headless; add it.");
    OpenWindow(options, size, scale).run();
}

}  // namespace momentscope
