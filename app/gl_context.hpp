// gl_context.hpp -- OpenGL contexts: a window that is shown, and kinds that are not shown, chosen by name.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string_view>

#include "app/crash_sentence.hpp"

struct GLFWwindow;

namespace momentscope {

/// The versions of OpenGL that contexts ask for, the best first. OpenGL 4.1 is what macOS has.
struct WantedGl {
    int major, minor;
};
constexpr WantedGl WANTED_GLS[] = {{4, 5}, {4, 1}, {3, 3}};

/// A current context of an OpenGL core profile or of OpenGL ES, with loaded functions; it stays current
/// during its lifetime. If its library crashes, because of an unknown driver or little memory, the user reads
/// why.
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

/// The GL of the display, in a window that is never shown.
std::unique_ptr<GlContext> make_hidden_context(glm::ivec2 size);

/// A kind of context that is not shown.
struct HeadlessGl {
    const char* key;  // of --gl
    const char* help;
    bool built;  // is it in this build?
    std::unique_ptr<GlContext> (*make)(glm::ivec2 size);
};

/// All kinds, the default first.
std::span<const HeadlessGl> headless_gls();

/// True if this build can draw where there is no display.
bool draws_without_display();

/// The kinds of this build, such as "osmesa, egl, egl-es, window or auto".
std::string headless_gl_keys();

/// The kind of the contexts that make_headless_context makes; for "auto", the kind that it takes. Throws
/// Error if MOMENTSCOPE_GL names none.
std::string headless_gl_key();

/// Chooses the kind of all contexts that make_headless_context makes from now on. Throws Error, with the
/// kinds of this build, if this one is not among them.
void choose_headless_gl(std::string_view key);

/// Chooses a kind unless the user did, by choose_headless_gl or by MOMENTSCOPE_GL.
void prefer_headless_gl(std::string_view key);

/// A context with a default framebuffer of this size. Its kind is the chosen one, or that in the environment
/// variable MOMENTSCOPE_GL, or the first of this build. Throws Error that says what to do.
std::unique_ptr<GlContext> make_headless_context(glm::ivec2 size);

}  // namespace momentscope
