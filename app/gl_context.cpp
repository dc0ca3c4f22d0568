#include "app/gl_context.hpp"

// glad must come first, because it requires that no other header has included GL.
#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

// The end of a sentence.
const char* instead_of_a_window(bool visible) {
    if (!visible) return "use another --gl.";
    return !draws_without_display() ? "start the program on a desktop with OpenGL 3.3 or newer."
                                    : "use --headless --screenshot FILE.png instead.";
}

class GlfwContext : public GlContext {
public:
    GlfwContext(glm::ivec2 size, bool visible) : visible_(visible) {
        if (glfwInit() == GLFW_FALSE)
            throw Error(fmt::format("There is no display for a window; {}", instead_of_a_window(visible)));
        glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS has no others
        for (const WantedGl& wanted : WANTED_GLS) {
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, wanted.major);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, wanted.minor);
            window_ = glfwCreateWindow(size.x, size.y, "Momentscope", nullptr, nullptr);
            if (window_ != nullptr) break;
        }
        if (window_ == nullptr) {
            glfwTerminate();
            throw Error(fmt::format("This display does not provide OpenGL 3.3; update its driver, or {}",
                                    instead_of_a_window(visible)));
        }
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        if (gladLoadGL(glfwGetProcAddress) == 0)
            throw Error("The OpenGL functions cannot be loaded; update the driver.");
    }
    ~GlfwContext() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    GlfwContext(const GlfwContext&) = delete;
    GlfwContext& operator=(const GlfwContext&) = delete;
    GLFWwindow* window() const override { return visible_ ? window_ : nullptr; }

private:
    bool visible_;
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_window_context(glm::ivec2 size) {
    return std::make_unique<GlfwContext>(size, true);
}

std::unique_ptr<GlContext> make_hidden_context(glm::ivec2 size) {
    return std::make_unique<GlfwContext>(size, false);
}

}  // namespace momentscope
