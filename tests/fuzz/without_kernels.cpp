// without_kernels.cpp -- replaces the mathematics, the built-in scenes and the shadows when only the readers
// are linked. No file reaches these parts, and building them with sanitizers takes minutes.
#include "core/report/page_files.hpp"
#include "core/scene/builtin_scenes.hpp"
#include "core/shadow/shadow_settings.hpp"
#include "core/support/version.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"
#include "core/techniques/pixel_state_techniques.hpp"
#include "ui/model/embedded_texts.hpp"

namespace momentscope {

const char* const PROGRAM_VERSION = "0";

namespace {

MomentKernel moment_kernel_of(int count, int bits) {
    MomentKernel kernel{};
    kernel.moment_floats = kernel.factor_floats = count;
    kernel.bits = bits;
    kernel.has_textbook = true;
    return kernel;
}

}  // namespace

const std::map<std::string_view, std::string_view>& embedded_glossary() {
    static const std::map<std::string_view, std::string_view> texts = {
        {"glossary.md", "\n\n**Moment** (b). A sum.\n\n**Absorbance.** Adds up.\n\n"}};
    return texts;
}

#define MOMENT_TECHNIQUE(id, basis, count, bits, ...)                         \
    const MomentKernel& moment_kernel(MomentKernelTag<MomentTechnique::id>) { \
        static const MomentKernel KERNEL = moment_kernel_of(count, bits);     \
        return KERNEL;                                                        \
    }
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE

#define PIXEL_STATE_TECHNIQUE(id, ...)                                                         \
    const PixelStateKernel& pixel_state_kernel(PixelStateKernelTag<PixelStateTechnique::id>) { \
        static const PixelStateKernel KERNEL{};                                                \
        return KERNEL;                                                                         \
    }
#include "core/techniques/pixel_state_techniques.def"
#undef PIXEL_STATE_TECHNIQUE

#define SCENE(id, description) \
    Scene build_##id() {       \
        return {};             \
    }
#include "core/scene/builtin_scenes.def"
#undef SCENE

const std::map<std::string_view, std::string_view>& page_files() {
    static const std::map<std::string_view, std::string_view> FILES = {
        {"chart.html", "{style}{metric}{method}{choices}{drawings}{rows}{script}"},
        {"chart.css", ""},
        {"chart.js", ""}};
    return FILES;
}
std::uint32_t add_mesh(Scene& /*scene*/, Mesh /*mesh*/) {
    return 0;
}
void add_ground(Scene& /*scene*/, float /*side*/, float /*y*/) {}
glm::vec3 linear_color(std::uint32_t /*srgb*/) {
    return {};
}

bool has_shadows(const ParameterValues& /*values*/) {
    return false;
}
Configuration light_configuration(const ParameterValues& /*values*/) {
    return {};
}
Configuration opaque_configuration(const ParameterValues& /*values*/) {
    return {};
}

}  // namespace momentscope
