#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "app/egl_context.hpp"
#include "app/gl_context.hpp"
#include "app/osmesa_context.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

const char* automatic_key() {
    if (HAS_EGL && (!HAS_OSMESA || has_egl_gpu())) return "egl";
    return HAS_OSMESA ? "osmesa" : "window";
}

std::unique_ptr<GlContext> make_automatic(glm::ivec2 size);

// A function, because constants of other files may not be set yet when constants are.
std::span<const HeadlessGl> rows() {
    static const HeadlessGl ROWS[] = {
        {"osmesa", "in software", HAS_OSMESA, make_osmesa_context},
        {"egl", "on a GPU, or in software if there is none", HAS_EGL, make_egl_context},
        {"egl-es", "the same as OpenGL ES 3.0", HAS_EGL, make_egl_es_context},
        {"window", "what a window of this display would use", true, make_hidden_context},
        {"auto", "a GPU if there is one, else osmesa", true, make_automatic},
    };
    return ROWS;
}

const HeadlessGl*& chosen() {
    static const HeadlessGl* row = nullptr;
    return row;
}

const HeadlessGl& require_headless_gl(std::string_view key) {
    const auto found = std::ranges::find_if(rows(), [&](const HeadlessGl& row) { return key == row.key; });
    if (found == rows().end() || !found->built)
        throw Error(fmt::format("This build does not draw by '{}'; use {}.", key, headless_gl_keys()));
    return *found;
}

std::unique_ptr<GlContext> make_automatic(glm::ivec2 size) {
    return require_headless_gl(automatic_key()).make(size);
}

std::string_view headless_gl_of_environment() {
    const char* const wanted = std::getenv("MOMENTSCOPE_GL");
    return wanted != nullptr ? wanted : "";
}

const HeadlessGl& default_headless_gl() {
    if (!headless_gl_of_environment().empty()) return require_headless_gl(headless_gl_of_environment());
    return *std::ranges::find_if(rows(), [](const HeadlessGl& row) { return row.built; });
}

}  // namespace

std::span<const HeadlessGl> headless_gls() {
    return rows();
}

std::string headless_gl_keys() {
    std::vector<std::string> keys;
    for (const HeadlessGl& row : rows())
        if (row.built) keys.emplace_back(row.key);
    std::string text;
    for (std::size_t i = 0; i < keys.size(); ++i)
        text += (i == 0 ? "" : i + 1 == keys.size() ? " or " : ", ") + keys[i];
    return text;
}

void choose_headless_gl(std::string_view key) {
    chosen() = &require_headless_gl(key);
}

bool draws_without_display() {
    return HAS_OSMESA || HAS_EGL;
}

void prefer_headless_gl(std::string_view key) {
    if (chosen() == nullptr && headless_gl_of_environment().empty()) choose_headless_gl(key);
}

std::string headless_gl_key() {
    const std::string key = (chosen() != nullptr ? *chosen() : default_headless_gl()).key;
    return key == "auto" ? automatic_key() : key;
}

std::unique_ptr<GlContext> make_headless_context(glm::ivec2 size) {
    if (!draws_without_display() && chosen() == nullptr && headless_gl_of_environment().empty())
        throw Error(
            "Pictures cannot be drawn without a window, because this program was built without OSMesa and EGL; give --gl "
            "window, or build it with the CMake option MOMENTSCOPE_OSMESA=ON or MOMENTSCOPE_EGL=ON.");
    return (chosen() != nullptr ? *chosen() : default_headless_gl()).make(size);
}

}  // namespace momentscope
