#include "app/egl_context.hpp"

// glad must come first, because it requires that no other header has included GL.
#include <glad/gl.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/support/error.hpp"

namespace momentscope {

const bool HAS_EGL = true;

namespace {

/// The functions of EGL. The library is loaded only when it is asked for.
struct Egl {
    decltype(&eglGetProcAddress) get_address;
    decltype(&eglQueryString) query_string;
    decltype(&eglGetDisplay) get_display;
    decltype(&eglInitialize) initialize;
    decltype(&eglTerminate) terminate;
    decltype(&eglBindAPI) bind_api;
    decltype(&eglChooseConfig) choose_config;
    decltype(&eglCreateContext) create_context;
    decltype(&eglDestroyContext) destroy_context;
    decltype(&eglCreatePbufferSurface) create_surface;
    decltype(&eglDestroySurface) destroy_surface;
    decltype(&eglMakeCurrent) make_current;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;  // null: not there
    PFNEGLQUERYDEVICESEXTPROC query_devices;
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string;
};

Egl load_egl() {
    void* const library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);  // never unloaded
    const auto load = [&](auto& pointer, const char* name) {
        void* const found = library != nullptr ? ::dlsym(library, name) : nullptr;
        if (found == nullptr)
            throw Error(
                fmt::format("EGL cannot be loaded ({}); install libegl1, or use --gl osmesa.", ::dlerror()));
        pointer = reinterpret_cast<std::decay_t<decltype(pointer)>>(found);
    };
    Egl egl{};
    load(egl.get_address, "eglGetProcAddress");
    load(egl.query_string, "eglQueryString");
    load(egl.get_display, "eglGetDisplay");
    load(egl.initialize, "eglInitialize");
    load(egl.terminate, "eglTerminate");
    load(egl.bind_api, "eglBindAPI");
    load(egl.choose_config, "eglChooseConfig");
    load(egl.create_context, "eglCreateContext");
    load(egl.destroy_context, "eglDestroyContext");
    load(egl.create_surface, "eglCreatePbufferSurface");
    load(egl.destroy_surface, "eglDestroySurface");
    load(egl.make_current, "eglMakeCurrent");
    const auto extension = [&](auto& pointer, const char* name) {
        pointer = reinterpret_cast<std::decay_t<decltype(pointer)>>(egl.get_address(name));
    };
    extension(egl.get_platform_display, "eglGetPlatformDisplayEXT");
    extension(egl.query_devices, "eglQueryDevicesEXT");
    extension(egl.query_device_string, "eglQueryDeviceStringEXT");
    return egl;
}

const Egl& egl() {
    static const Egl library = load_egl();
    return library;
}

bool has_extension(const char* extensions, std::string_view name) {
    const std::string_view all = extensions == nullptr ? "" : extensions;
    return all.find(name) != std::string_view::npos;
}

/// A way to draw without a window.
struct Place {
    std::string name;
    EGLDisplay display;
};

std::vector<EGLDeviceEXT> devices(bool software) {
    std::vector<EGLDeviceEXT> found;
    const char* client = egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (egl().query_devices == nullptr || egl().query_device_string == nullptr ||
        !has_extension(client, "EGL_EXT_platform_device"))
        return found;
    EGLint count = 0;
    std::array<EGLDeviceEXT, 16> all{};
    if (egl().query_devices(static_cast<EGLint>(all.size()), all.data(), &count) == EGL_FALSE) return found;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const char* extensions = egl().query_device_string(all[i], EGL_EXTENSIONS);
        if (has_extension(extensions, "EGL_MESA_device_software") == software) found.push_back(all[i]);
    }
    return found;
}

// GPUs first.
std::vector<Place> places() {
    std::vector<Place> found;
    if (egl().get_platform_display != nullptr) {
        const std::vector<EGLDeviceEXT> gpus = devices(false);
        for (std::size_t i = 0; i < gpus.size(); ++i)
            found.push_back({fmt::format("device {}", i),
                             egl().get_platform_display(EGL_PLATFORM_DEVICE_EXT, gpus[i], nullptr)});
        if (has_extension(egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                          "EGL_MESA_platform_surfaceless"))
            found.push_back(
                {"Mesa without a surface",
                 egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA,
                                            reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr)});
    }
    found.push_back({"the default display", egl().get_display(EGL_DEFAULT_DISPLAY)});
    return found;
}

/// OpenGL or OpenGL ES, as EGL and its loader know it.
struct EglApi {
    const char* name;
    EGLenum api;
    EGLint renderable;
    std::span<const WantedGl> versions;
    int (*load)(GLADloadfunc);
};

constexpr WantedGl WANTED_ES[] = {{3, 0}};
constexpr EglApi OPENGL = {"OpenGL", EGL_OPENGL_API, EGL_OPENGL_BIT, WANTED_GLS, gladLoadGL};
constexpr EglApi OPENGL_ES = {"OpenGL ES", EGL_OPENGL_ES_API, EGL_OPENGL_ES3_BIT, WANTED_ES, gladLoadGLES2};

class EglContext : public GlContext {
public:
    EglContext(const Place& place, glm::ivec2 size, const EglApi& api) : display_(place.display) {
        if (display_ == EGL_NO_DISPLAY || egl().initialize(display_, nullptr, nullptr) == EGL_FALSE)
            throw Error("does not start");
        try {
            begin(size, api);
        } catch (...) {
            end();
            throw;
        }
    }
    ~EglContext() override { end(); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

private:
    void begin(glm::ivec2 size, const EglApi& api) {
        const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 api.renderable,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_NONE};
        const EGLint surface[] = {EGL_WIDTH, size.x, EGL_HEIGHT, size.y, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (egl().bind_api(api.api) == EGL_FALSE ||
            egl().choose_config(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
            throw Error(fmt::format("has no {}", api.name));
        for (const WantedGl& version : api.versions) {
            context_ =
                egl().create_context(display_, config, EGL_NO_CONTEXT, attributes(api, version).data());
            if (context_ != EGL_NO_CONTEXT) break;
        }
        surface_ = egl().create_surface(display_, config, surface);
        if (context_ == EGL_NO_CONTEXT || surface_ == EGL_NO_SURFACE ||
            egl().make_current(display_, surface_, surface_, context_) == EGL_FALSE)
            throw Error(fmt::format("has no {} {}.{}", api.name, api.versions.back().major,
                                    api.versions.back().minor));
        if (api.load(egl().get_address) == 0) throw Error(fmt::format("has no functions of {}", api.name));
    }

    // OpenGL ES has no profiles.
    static std::array<EGLint, 7> attributes(const EglApi& api, const WantedGl& version) {
        const bool profiles = api.api == EGL_OPENGL_API;
        return {EGL_CONTEXT_MAJOR_VERSION,
                version.major,
                EGL_CONTEXT_MINOR_VERSION,
                version.minor,
                profiles ? EGL_CONTEXT_OPENGL_PROFILE_MASK : EGL_NONE,
                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                EGL_NONE};
    }

    void end() {
        egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) egl().destroy_surface(display_, surface_);
        if (context_ != EGL_NO_CONTEXT) egl().destroy_context(display_, context_);
        egl().terminate(display_);
    }

    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

std::unique_ptr<GlContext> make_context(glm::ivec2 size, const EglApi& api) {
    std::string tried;
    for (const Place& place : places()) {
        try {
            return std::make_unique<EglContext>(place, size, api);
        } catch (const Error& error) {
            tried += fmt::format("{}{} {}", tried.empty() ? "" : ", ", place.name, error.what());
        }
    }
    throw Error(fmt::format(
        "EGL cannot draw: {}. Install libegl-mesa0 or the driver of the GPU, or use --gl osmesa.", tried));
}

}  // namespace

bool has_egl_gpu() {
    try {
        return !devices(false).empty();
    } catch (const Error&) {  // there is no EGL
        return false;
    }
}

std::unique_ptr<GlContext> make_egl_context(glm::ivec2 size) {
    return make_context(size, OPENGL);
}

std::unique_ptr<GlContext> make_egl_es_context(glm::ivec2 size) {
    return make_context(size, OPENGL_ES);
}

}  // namespace momentscope
