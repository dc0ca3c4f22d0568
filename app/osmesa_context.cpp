#include "app/osmesa_context.hpp"

// glad must come first, because it requires that no other header has included GL.
#include <glad/gl.h>

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <type_traits>
#include <vector>

#include "core/support/error.hpp"

namespace momentscope {

const bool HAS_OSMESA = true;

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
        for (const WantedGl& wanted : WANTED_GLS) {
            const int attributes[] = {OSMESA_FORMAT,
                                      OSMESA_RGBA,
                                      OSMESA_DEPTH_BITS,
                                      24,
                                      OSMESA_PROFILE,
                                      OSMESA_CORE_PROFILE,
                                      OSMESA_CONTEXT_MAJOR_VERSION,
                                      wanted.major,
                                      OSMESA_CONTEXT_MINOR_VERSION,
                                      wanted.minor,
                                      0};
            context_ = osmesa().create_context(attributes, nullptr);
            if (context_ != nullptr) break;
        }
        if (context_ == nullptr ||
            osmesa().make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, size.x, size.y) == GL_FALSE ||
            gladLoadGL(osmesa().get_address) == 0)
            throw Error(
                "OSMesa does not provide OpenGL 3.3; install libosmesa6 22 or newer, or give the program more memory.");
    }
    ~OsMesaContext() override { osmesa().destroy_context(context_); }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

private:
    std::vector<unsigned char> pixels_;
    OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(glm::ivec2 size) {
    return std::make_unique<OsMesaContext>(size);
}

}  // namespace momentscope
