#include "app/gui_session.hpp"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include "ui/shortcut.hpp"
#include "ui/theme.hpp"

namespace momentscope {

GuiSession::GuiSession(GLFWwindow* window, float ui_scale) : window_(window) {
    ImGui::CreateContext();
    ui::load_fonts(ui_scale);
    if (window_ != nullptr) {
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, on_key);
    } else {
        ui::use_key_numbers();
    }
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

GuiSession::~GuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void GuiSession::on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    auto& session = *static_cast<GuiSession*>(glfwGetWindowUserPointer(window));
    session.pressed_ |= action == GLFW_PRESS;
    if (action == GLFW_RELEASE && session.pressed_)
        session.releases_.push_back({key, scancode, modifiers});
    else
        ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
}

void GuiSession::release_keys() {
    pressed_ = false;
    for (const Release& release : releases_)
        ImGui_ImplGlfw_KeyCallback(window_, release.key, release.scancode, GLFW_RELEASE, release.modifiers);
    releases_.clear();
}

void GuiSession::begin_frame(glm::ivec2 size, float seconds) {
    ImGui_ImplOpenGL3_NewFrame();
    if (window_ != nullptr) {
        ImGui_ImplGlfw_NewFrame();
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
    if (window_ != nullptr) release_keys();
}

void GuiSession::end_frame() {
    ImGui::Render();
}

void GuiSession::paint(glm::ivec2 size) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace momentscope
