#include "app/gui_session.hpp"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <string>

#include "core/gl/capabilities.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/support/error.hpp"
#include "ui/widgets/shortcut.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope {

namespace {

// Dear ImGui's backend calls functions of OpenGL that OpenGL ES does not have, unless it is built for it.
std::string shader_version() {
    const DialectRow& dialect = row_of(current_dialect());
    if (dialect.dialect == Dialect::essl_300)
        throw Error("This build draws its window by OpenGL, not by OpenGL ES; use another --gl.");
    return dialect.version;
}

}  // namespace

GuiSession::GuiSession(GLFWwindow* window, float ui_scale) : window_(window) {
    const std::string version = shader_version();
    ImGui::CreateContext();
    ui::load_fonts(ui_scale);
    if (window_ != nullptr) {
        ImGui_ImplGlfw_InitForOpenGL(window_, false);
        input_ = std::make_unique<WindowInput>(window_);
    } else {
        ui::use_key_numbers();
    }
    ImGui_ImplOpenGL3_Init(version.c_str());
}

GuiSession::~GuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void GuiSession::set_scale(float ui_scale) {
    ImGui::GetIO().Fonts->Clear();
    ui::load_fonts(ui_scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void GuiSession::begin_frame(glm::ivec2 size, float seconds) {
    ImGui_ImplOpenGL3_NewFrame();
    if (window_ != nullptr) {
        ImGui_ImplGlfw_NewFrame();
        input_->begin_frame(ImGui::GetIO());
    } else {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
        io.DeltaTime = seconds;
    }
    ImGui::NewFrame();
}

void GuiSession::end_frame(glm::ivec2 size) {
    end_frame();
    paint(size);
    if (window_ != nullptr) last_.keep(size);
}

void GuiSession::end_frame() {
    ImGui::Render();
}

void GuiSession::paint(glm::ivec2 size) const {
    clear_window(size);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GuiSession::paint_over_last(glm::ivec2 size, const std::function<void(ImDrawList&)>& draw) const {
    last_.show(size);
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    draw(list);
    ImDrawList* lists[] = {&list};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.TotalVtxCount = list.VtxBuffer.Size;
    data.DisplaySize = ImGui::GetIO().DisplaySize;
    data.FramebufferScale = ImGui::GetIO().DisplayFramebufferScale;
    ImGui_ImplOpenGL3_RenderDrawData(&data);
}

}  // namespace momentscope
