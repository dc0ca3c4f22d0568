// gl_context.hpp -- the two ways to get an OpenGL context, chosen by name.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "app/crash_sentence.hpp"

struct GLFWwindow;

namespace momentscope {

/// A current OpenGL 4.5 core context with loaded functions; it stays current until it dies. When its library
/// crashes, with an unknown driver or little memory, the user reads why.
class GlContext {
public:
    virtual ~GlContext() = default;

    /// The window, or null when there is none.
    virtual GLFWwindow* window() const { return nullptr; }

private:
    CrashSentence crash_{
        "OpenGL crashed; unset GALLIUM_DRIVER, give the program more memory or a smaller --size, and report the crash "
        "if nothing helps."};
};

/// "glfw": a window of that size. "osmesa": software rendering without a display; the default framebuffer has
/// that size. Throws Error that says what to do.
std::unique_ptr<GlContext> make_gl_context(std::string_view name, glm::ivec2 size);

/// The default framebuffer as sRGB RGBA bytes, row by row from the top.
std::vector<unsigned char> read_framebuffer(glm::ivec2 size);

}  // namespace momentscope
