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
const char* instead_of_a_window() {
    return headless_gl_keys().empty() ? "start the program on a desktop with OpenGL 4.5."
                                      : "use --headless --screenshot FILE.png instead.";
}

class GlfwContext : public GlContext {
public:
    explicit GlfwContext(glm::ivec2 size) {
        if (glfwInit() == GLFW_FALSE)
            throw Error(fmt::format("There is no display for a window; {}", instead_of_a_window()));
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(size.x, size.y, "Momentscope", nullptr, nullptr);
        if (window_ == nullptr) {
            glfwTerminate();
            throw Error(fmt::format("This display does not provide OpenGL 4.5; update its driver, or {}",
                                    instead_of_a_window()));
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
    GLFWwindow* window() const override { return window_; }

private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_window_context(glm::ivec2 size) {
    return std::make_unique<GlfwContext>(size);
}

}  // namespace momentscope
