#include "app/gl_context.hpp"

// glad must come first, because it requires that no other header has included GL.
#include <glad/gl.h>

#include <GL/osmesa.h>
#include <dlfcn.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

/// The functions of OSMesa. The library is loaded only when a picture is drawn without a window, because
/// loading it with LLVM takes 50 ms.
struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) create_context;
    decltype(&OSMesaMakeCurrent) make_current;
    decltype(&OSMesaDestroyContext) destroy_context;
    decltype(&OSMesaGetProcAddress) get_address;
};

OsMesa load_osmesa() {
    void* const library = ::dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);  // never unloaded
    const auto function = [&](const char* name) {
        void* const found = library != nullptr ? ::dlsym(library, name) : nullptr;
        if (found == nullptr)
            throw Error(fmt::format(
                "Pictures cannot be drawn without a window, because OSMesa cannot be loaded ({}); "
                "install libosmesa6 22 or newer.",
                ::dlerror()));
        return found;
    };
    OsMesa osmesa{};
    const auto load = [&](auto& pointer, const char* name) {
        pointer = reinterpret_cast<std::decay_t<decltype(pointer)>>(function(name));
    };
    load(osmesa.create_context, "OSMesaCreateContextAttribs");
    load(osmesa.make_current, "OSMesaMakeCurrent");
    load(osmesa.destroy_context, "OSMesaDestroyContext");
    load(osmesa.get_address, "OSMesaGetProcAddress");
    return osmesa;
}

const OsMesa& osmesa() {
    static const OsMesa library = load_osmesa();
    return library;
}

class OsMesaContext : public GlContext {
public:
    explicit OsMesaContext(glm::ivec2 size)
        : pixels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  4,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  5,
                                  0};
        context_ = osmesa().create_context(attributes, nullptr);
        if (context_ == nullptr ||
            osmesa().make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, size.x, size.y) == GL_FALSE ||
            gladLoadGL(osmesa().get_address) == 0)
            throw Error(
                "OSMesa does not provide OpenGL 4.5; install libosmesa6 22 or newer, or give the program more memory.");
    }
    ~OsMesaContext() override { osmesa().destroy_context(context_); }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

private:
    std::vector<unsigned char> pixels_;
    OSMesaContext context_ = nullptr;
};

class GlfwContext : public GlContext {
public:
    explicit GlfwContext(glm::ivec2 size) {
        if (glfwInit() == GLFW_FALSE)
            throw Error("There is no display for a window; use --headless --screenshot FILE.png instead.");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(size.x, size.y, "Momentscope", nullptr, nullptr);
        if (window_ == nullptr) {
            glfwTerminate();
            throw Error("This display does not provide OpenGL 4.5; update its driver, or use --headless.");
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

std::unique_ptr<GlContext> make_gl_context(std::string_view name, glm::ivec2 size) {
    if (name == "osmesa") return std::make_unique<OsMesaContext>(size);
    if (name == "glfw") return std::make_unique<GlfwContext>(size);
    throw Error(fmt::format("There is no GL context '{}'; use glfw or osmesa.", name));
}

std::vector<unsigned char> read_framebuffer(glm::ivec2 size) {
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<unsigned char> pixels(row * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y) / 2; ++y)
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return pixels;
}

}  // namespace momentscope
