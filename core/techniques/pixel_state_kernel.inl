// pixel_state_kernel.inl -- the body of a PixelStateKernel. A file that CMake generates from
// pixel_state_kernel.cpp.in defines KERNEL_ID and PIXEL_STATE_FILE (a file of shaders/shared) and includes
// this file.
#include "core/support/glsl.hpp"
#include "core/techniques/pixel_state_kernel.hpp"
#include "core/techniques/pixel_state_techniques.hpp"
#include "core/techniques/quantisation.hpp"

#include <algorithm>

namespace momentscope {
namespace glsl::KERNEL_ID {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // all techniques have the same signatures
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// fragment.glsl needs portable_math.glsl before it.
#include "shaders/shared/fragment.glsl"
#include "shaders/shared/random_bits.glsl"
// For techniques that read moments in 16 bits.
constexpr auto THETA_ODD = flat_floats(quantisation_transform<4>().odd);
constexpr auto THETA_EVEN = flat_floats(quantisation_transform<4>().even);
constexpr auto THETA_ODD_INVERSE = flat_floats(inverse(quantisation_transform<4>().odd));
constexpr auto THETA_EVEN_INVERSE = flat_floats(inverse(quantisation_transform<4>().even));
constexpr auto THETA_EVEN_OFFSET = floats(quantisation_transform<4>().even_offset);
#include PIXEL_STATE_FILE
constexpr int STATE_FLOATS = MAX_STATE_FLOATS;
#pragma GCC diagnostic pop
}  // namespace glsl::KERNEL_ID

namespace {

namespace g = glsl::KERNEL_ID;
static_assert(g::STATE_FLOATS <= STATE_CAPACITY && g::STATE_FLOATS % 4 == 0);

#ifdef SETTINGS
template <typename Type>
constexpr PixelStateSetting::Type TYPE = PixelStateSetting::Type::number;
template <>
constexpr PixelStateSetting::Type TYPE<int> = PixelStateSetting::Type::integer;
template <>
constexpr PixelStateSetting::Type TYPE<bool> = PixelStateSetting::Type::boolean;

#define ROW(type, name) PixelStateSetting{ParameterId::name, TYPE<type>},
constexpr PixelStateSetting SETTING_ROWS[] = {SETTINGS(ROW)};
constexpr std::span<const PixelStateSetting> KERNEL_SETTINGS = SETTING_ROWS;
static_assert(std::ranges::all_of(KERNEL_SETTINGS,
                                  [](const PixelStateSetting& one) {
                                      return one.type != PixelStateSetting::Type::number ||
                                             one.parameter == ParameterId::beta ||
                                             one.parameter == ParameterId::alpha;
                                  }),
              "shaders read no other parameter from the uniform block (settings_text in state_passes.cpp)");

g::PixelStateSettings settings_from(const ParameterValues& values) {
#define VALUE(type, name) static_cast<type>(values.number(ParameterId::name)),
    return {SETTINGS(VALUE)};
}
#else
constexpr std::span<const PixelStateSetting> KERNEL_SETTINGS;

g::PixelStateSettings settings_from(const ParameterValues&) {
    return {};
}
#endif

g::PixelStateFragment to_shared(const PixelStateFragment& f) {
    return {f.depth, f.view_depth, f.window_depth, f.plane_depth, f.opacity,
            f.red,   f.green,      f.blue,         f.seed,        f.threshold};
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

// One number after another, as blending does it.
[[maybe_unused]] PixelState blended(const PixelState& state, const PixelState& added, float kept) {
    PixelState sum = state;
    for (std::size_t i = 0; i < std::size_t{g::STATE_FLOATS}; ++i) sum.f[i] = added.f[i] + kept * sum.f[i];
    return sum;
}

PixelState empty_state(const ParameterValues& values) {
    return from_shared(g::empty_state(settings_from(values)));
}

PixelState with_fragment(const PixelState& state, const PixelStateFragment& fragment,
                         const ParameterValues& values) {
#ifdef STATE_ORDERED
    return from_shared(g::with_fragment(to_shared(state), to_shared(fragment), settings_from(values)));
#else
    const PixelState added = from_shared(g::fragment_state(to_shared(fragment), settings_from(values)));
#if defined(STATE_NEAREST)
    return added.f[3] <= state.f[3] ? added : state;
#elif defined(STATE_SAMPLES)
    PixelState result = state;
    result.f[0] += added.f[0];
    for (std::size_t i = 1; i < result.f.size(); ++i) result.f[i] = std::min(result.f[i], added.f[i]);
    return result;
#elif defined(STATE_OVER)
    return blended(state, added, 1.0f - added.f[3]);
#else
    return blended(state, added, 1.0f);
#endif
#endif
}

#ifdef SECOND_STATE
PixelState accumulate_second_pass(const PixelState& state, const PixelState& read,
                                  const PixelStateFragment& fragment, const ParameterValues& values) {
    return blended(
        state,
        from_shared(g::second_fragment_state(to_shared(read), to_shared(fragment), settings_from(values))),
        1.0f);
}

PixelState readable(const PixelState& state, const ParameterValues& values) {
    return from_shared(
        g::filterable(g::converted(to_shared(state), settings_from(values)), settings_from(values)));
}
#else
constexpr auto accumulate_second_pass = nullptr;

PixelState readable(const PixelState& state, const ParameterValues&) {
    return state;
}
#endif

#ifdef EXACT_ABSORBANCE_SLOT
constexpr int SLOT = EXACT_ABSORBANCE_SLOT;
#else
constexpr int SLOT = -1;
#endif

Composited composited(const PixelState& state, const ParameterValues& values) {
    const g::Composited result = g::composited(to_shared(state), settings_from(values));
    return {result.red, result.green, result.blue, result.transmittance};
}

#ifdef WITHOUT_DEPTHS
constexpr auto transmittance_at = nullptr;
#else
float transmittance_at(const PixelState& state, const PixelStateFragment& fragment,
                       const ParameterValues& values) {
    return g::transmittance_at(to_shared(state), to_shared(fragment), settings_from(values));
}
#endif

#if defined(STATE_SUMS)
constexpr Accumulation ACCUMULATION = Accumulation::sum;
#elif defined(STATE_OVER)
constexpr Accumulation ACCUMULATION = Accumulation::over;
#elif defined(STATE_SAMPLES)
constexpr Accumulation ACCUMULATION = Accumulation::samples;
#elif defined(STATE_NEAREST)
constexpr Accumulation ACCUMULATION = Accumulation::nearest;
#else
constexpr Accumulation ACCUMULATION = Accumulation::ordered;
#endif

#ifdef HOLDS_COLORS
constexpr bool COLORS = true;
#else
constexpr bool COLORS = false;
#endif

}  // namespace

const PixelStateKernel& pixel_state_kernel(PixelStateKernelTag<PixelStateTechnique::KERNEL_ID>) {
    static constexpr PixelStateKernel kernel = {.settings = KERNEL_SETTINGS,
                                                .accumulation = ACCUMULATION,
                                                .holds_colors = COLORS,
                                                .empty_state = empty_state,
                                                .with_fragment = with_fragment,
                                                .transmittance_at = transmittance_at,
                                                .accumulate_second_pass = accumulate_second_pass,
                                                .readable = readable,
                                                .exact_absorbance_slot = SLOT,
                                                .composited = composited};
    return kernel;
}

}  // namespace momentscope
