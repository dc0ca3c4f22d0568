#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdio>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/gui_session.hpp"
#include "core/error.hpp"
#include "core/ray/ray_json.hpp"
#include "ui/explorer.hpp"

namespace momentscope {

namespace {

constexpr int SETTLING_FRAMES =
    3;  // ImGui needs a few to lay out and to let hovered and active states settle

ui::ExplorerState initial_state(const Options& options) {
    ui::ExplorerState state;
    state.parameters = parse_parameters(options);
    const auto techniques = parse_techniques(options, "power6-32");
    if (techniques.size() != 1) throw Error("The window shows one technique; give a single --technique.");
    state.technique = techniques.front();
    state.scene = options.scene;
    if (!options.ray.empty()) state.ray = read_ray_file(options.ray);
    return state;
}

// --pixel counts in the scene's picture, whose size only a drawn frame knows.
void pick_option(const Options& options, ui::Explorer& explorer) {
    if (options.pixel.empty()) return;
    const glm::ivec2 size = explorer.result().picture_size;
    explorer.state().picked = (glm::vec2(parse_pixel(options.pixel, size)) + 0.5f) / glm::vec2(size);
}

void draw_frame(GuiSession& gui, ui::Explorer& explorer, glm::ivec2 size) {
    gui.begin_frame(size);
    explorer.frame();
    gui.end_frame(size);
}

void explore_headless(const Options& options, glm::ivec2 size) {
    if (options.screenshot.empty()) throw Error("--headless draws into a file; add --screenshot FILE.png.");
    require_writable(options.screenshot);
    if (std::filesystem::path(options.screenshot).extension() != ".png")
        throw Error(fmt::format("A screenshot is a .png; '{}' is not.", options.screenshot));
    const ui::ExplorerState state = initial_state(options);
    const auto context = make_gl_context("osmesa", size);
    Renderer renderer;
    GuiSession gui(nullptr, 1.0f);
    ui::Explorer explorer(renderer, state);
    draw_frame(gui, explorer, size);
    pick_option(options, explorer);
    for (int i = 0; i < SETTLING_FRAMES; ++i) draw_frame(gui, explorer, size);
    if (!explorer.message().empty()) throw Error(explorer.message());
    write_png(read_framebuffer(size), size.x, size.y, options.screenshot);
}

void explore_window(const Options& options, glm::ivec2 size) {
    if (!options.screenshot.empty()) throw Error("--screenshot needs --headless; add it.");
    const auto context = make_gl_context("glfw", size);
    const ui::ExplorerState state = initial_state(options);
    Renderer renderer;
    GuiSession gui(context->window(), 1.0f);
    ui::Explorer explorer(renderer, state);
    bool picked = false;
    // Draws while there is input and shortly after; then waits for more.
    for (int frames = SETTLING_FRAMES; glfwWindowShouldClose(context->window()) == GLFW_FALSE;) {
        glm::ivec2 framebuffer;
        glfwGetFramebufferSize(context->window(), &framebuffer.x, &framebuffer.y);
        if (framebuffer.x > 0 && framebuffer.y > 0) {
            draw_frame(gui, explorer, framebuffer);
            if (!picked) pick_option(options, explorer);
            picked = true;
            glfwSwapBuffers(context->window());
        }
        if (frames > 0) {
            --frames;
            glfwPollEvents();
        } else {
            glfwWaitEvents();
            frames = SETTLING_FRAMES;
        }
    }
}

}  // namespace

void run_explore(const Options& options) {
    const glm::ivec2 size = parse_size(options.size.empty() ? "1280x800" : options.size);
    if (options.headless)
        explore_headless(options, size);
    else
        explore_window(options, size);
}

}  // namespace momentscope
