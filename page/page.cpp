#include "page/page.hpp"

#include <glad/gl.h>

#include <emscripten/html5.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>

#include "core/gl/framebuffer.hpp"
#include "core/image/image.hpp"
#include "core/support/error.hpp"
#include "page/host_calls.hpp"
#include "ui/model/link.hpp"
#include "ui/widgets/shortcut.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope {

namespace {

ui::Host host() {
    return {.choose_file = choose_file,
            .deliver = deliver_file,
            .copy_link = [](const ui::ExplorerState& state) { copy_link(ui::link_text(state).c_str()); },
            .keep = keep,
            .kept = [](const std::string& name) { return kept_texts()[name]; },
            .toggle_fullscreen = toggle_fullscreen};
}

}  // namespace

void make_web_context() {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.depth = wanted.antialias = EM_FALSE;
    wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#canvas", &wanted);
    if (context <= 0)
        throw Error(
            "This browser has no WebGL 2, which draws the scene; use a current browser, or turn on graphics acceleration in "
            "its settings.");
    emscripten_webgl_make_context_current(context);
    prepare_web_context();
    gladLoadGLES2([](const char* name) {
        return reinterpret_cast<GLADapiproc>(emscripten_webgl_get_proc_address(name));
    });
}

void prepare_web_context() {
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_get_current_context();
    for (const char* extension : {"EXT_color_buffer_float", "EXT_float_blend", "WEBGL_debug_renderer_info"})
        emscripten_webgl_enable_extension(context, extension);
}

Page::Page(const ui::ExplorerState& start, const ui::Embedding& embedding, glm::ivec2 size, float scale)
    : size_(size), own_scale_(scale), scale_(scale) {
    ImGui::CreateContext();
    ui::load_fonts(scale);
    ui::use_key_numbers();
    ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { copy_text(text); };
    ImGui_ImplOpenGL3_Init("#version 300 es");
    renderer_ = std::make_unique<Renderer>();
    explorer_ = std::make_unique<ui::Explorer>(*renderer_, start,
                                               ui::WindowOptions{.scale = scale,
                                                                 .show_times = false,  // WebGL has no timers
                                                                 .most_milliseconds = ui::DRAG_MILLISECONDS,
                                                                 .before_long_picture = [] { return true; },
                                                                 .settings = ui::NEW_USER,
                                                                 .host = host(),
                                                                 .embedding = embedding});
    linked_ = workspace().state;
}

Page::~Page() {
    explorer_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

bool Page::frame(double seconds) {
    if (!input_.empty()) need_.input();
    if (!need_.due(*explorer_)) return false;
    use_scale();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_.x), static_cast<float>(size_.y)};
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 0.5));
    input_.begin_frame(io);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    explorer_->frame();
    ImGui::Render();
    clear_window(size_);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    need_.drawn();
    if (const auto path = workspace().files.take_window_export()) write_window(*path);
    return true;
}

void Page::write_window(const std::filesystem::path& path) {
    try {
        write_png(read_window(size_), size_.x, size_.y, path);
        workspace().files.window_written(path, workspace());
    } catch (const Error& error) {
        workspace().status.say(error.what());
    }
}

void Page::resize(glm::ivec2 size, float scale) {
    size_ = size;
    own_scale_ = scale;
    need_.input();
}

void Page::use_scale() {
    const float scale = explorer_->wanted_scale(own_scale_);
    if (scale == scale_) return;
    scale_ = scale;
    ImGui::GetIO().Fonts->Clear();
    ui::load_fonts(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    explorer_->set_scale(scale);
}

std::string Page::take_step() {
    const ui::ExplorerState& state = workspace().state;
    if (state == linked_ || !explorer_->is_at_a_step()) return "";
    linked_ = state;
    return ui::link_text(state);
}

void Page::open(const ui::ExplorerState& state) {
    workspace().state = linked_ = state;
    need_.input();
}

}  // namespace momentscope
