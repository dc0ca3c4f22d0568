// gl_context.hpp -- the two kinds of OpenGL contexts, chosen by name.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "app/crash_sentence.hpp"

struct GLFWwindow;

namespace momentscope {

/// A current OpenGL 4.5 core context with loaded functions; it stays current during its lifetime. If its
/// library crashes, because of an unknown driver or little memory, the user reads why.
class GlContext {
public:
    virtual ~GlContext() = default;

    /// The window, or null if there is none.
    virtual GLFWwindow* window() const { return nullptr; }

private:
    CrashSentence crash_{
        "OpenGL crashed; unset GALLIUM_DRIVER, give the program more memory or a smaller --size, and report the crash "
        "if nothing helps."};
};

/// "glfw": a window of this size. "osmesa": software rendering without a display, with a default framebuffer
/// of this size. Throws Error that says what to do.
std::unique_ptr<GlContext> make_gl_context(std::string_view name, glm::ivec2 size);

}  // namespace momentscope
