// gl_context.hpp -- OpenGL contexts: a window, and the kinds that need no display, chosen by name.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string_view>

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

/// A window of this size. Throws Error that says what to do.
std::unique_ptr<GlContext> make_window_context(glm::ivec2 size);

/// A kind of context that needs no display.
struct HeadlessGl {
    const char* key;  // of --gl
    const char* help;
    bool built;  // is it in this build?
    std::unique_ptr<GlContext> (*make)(glm::ivec2 size);
};

/// All kinds, the default first.
std::span<const HeadlessGl> headless_gls();

/// The kinds of this build, such as "osmesa, egl or auto"; "" if there is none.
std::string headless_gl_keys();

/// Chooses the kind of all contexts that make_headless_context makes from now on. Throws Error, with the
/// kinds of this build, if this one is not among them.
void choose_headless_gl(std::string_view key);

/// A context with a default framebuffer of this size. Its kind is the chosen one, or that in the environment
/// variable MOMENTSCOPE_GL, or the first of this build. Throws Error that says what to do.
std::unique_ptr<GlContext> make_headless_context(glm::ivec2 size);

}  // namespace momentscope
