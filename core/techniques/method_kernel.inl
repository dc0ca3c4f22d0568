// method_kernel.inl -- the body of a MethodKernel. A file generated from method_kernel.cpp.in defines KERNEL_ID and METHOD_FILE
// (a file of shaders/shared) and includes this.
#include "core/glsl.hpp"
#include "core/techniques/method_kernel.hpp"
#include "core/techniques/method_techniques.hpp"

#include <algorithm>

namespace momentscope {
namespace glsl::KERNEL_ID {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // the shape is the same for every technique
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// portable_math first: fragment.glsl builds on it
#include "shaders/shared/fragment.glsl"
#include METHOD_FILE
constexpr int STATE_FLOATS = MAX_STATE_FLOATS;
#pragma GCC diagnostic pop
}  // namespace glsl::KERNEL_ID

namespace {

namespace g = glsl::KERNEL_ID;
static_assert(g::STATE_FLOATS <= STATE_CAPACITY && g::STATE_FLOATS % 4 == 0);

g::MethodSettings to_shared(const MethodSettings& settings) {
    return {settings.size, settings.option};
}

g::MethodFragment to_shared(const MethodFragment& f) {
    return {f.depth, f.view_depth, f.window_depth, f.opacity, f.red, f.green, f.blue};
}

g::PixelState to_shared(const PixelState& state) {
    g::PixelState shared;
    std::copy_n(state.f.begin(), g::STATE_FLOATS, shared.f);
    return shared;
}

PixelState from_shared(const g::PixelState& shared) {
    PixelState state;
    std::copy_n(shared.f, g::STATE_FLOATS, state.f.begin());
    return state;
}

PixelState empty_state(const MethodSettings& settings) {
    return from_shared(g::empty_state(to_shared(settings)));
}

PixelState with_fragment(const PixelState& state, const MethodFragment& fragment,
                         const MethodSettings& settings) {
#ifdef STATE_ORDERED
    return from_shared(g::with_fragment(to_shared(state), to_shared(fragment), to_shared(settings)));
#else
    const g::PixelState added = g::fragment_state(to_shared(fragment), to_shared(settings));
    PixelState sum = state;
#ifdef STATE_OVER
    const float kept = 1.0f - added.f[3];
#else
    const float kept = 1.0f;
#endif
    for (int i = 0; i < g::STATE_FLOATS; ++i) {
        float& number = sum.f[static_cast<std::size_t>(i)];
        number = added.f[i] + kept * number;
    }
    return sum;
#endif
}

Composited composited(const PixelState& state, const MethodSettings& settings) {
    const g::Composited result = g::composited(to_shared(state), to_shared(settings));
    return {result.red, result.green, result.blue, result.transmittance};
}

#ifdef WITHOUT_DEPTHS
constexpr auto transmittance_at = nullptr;
#else
float transmittance_at(const PixelState& state, const MethodFragment& fragment,
                       const MethodSettings& settings) {
    return g::transmittance_at(to_shared(state), to_shared(fragment), to_shared(settings));
}
#endif

#if defined(STATE_SUMS)
constexpr Accumulation ACCUMULATION = Accumulation::sum;
#elif defined(STATE_OVER)
constexpr Accumulation ACCUMULATION = Accumulation::over;
#else
constexpr Accumulation ACCUMULATION = Accumulation::ordered;
#endif

#ifdef HOLDS_COLORS
constexpr bool COLORS = true;
#else
constexpr bool COLORS = false;
#endif

}  // namespace

const MethodKernel& method_kernel(MethodKernelTag<MethodTechnique::KERNEL_ID>) {
    static constexpr MethodKernel kernel = {.accumulation = ACCUMULATION,
                                            .holds_colors = COLORS,
                                            .empty_state = empty_state,
                                            .with_fragment = with_fragment,
                                            .transmittance_at = transmittance_at,
                                            .composited = composited};
    return kernel;
}

}  // namespace momentscope
