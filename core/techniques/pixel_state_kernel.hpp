// pixel_state_kernel.hpp -- one technique without moments as C++ functions: shaders/shared, compiled for the
// CPU.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/parameters/parameters.hpp"

namespace momentscope {

constexpr int STATE_CAPACITY = 68;

/// What a pixel stores. The math file of the technique says what each number is.
struct PixelState {
    std::array<float, STATE_CAPACITY> f{};
};

/// A fragment as in shaders/shared/pixel_state.glsl. depth in [0, 1] of the depth range. Colours are not
/// multiplied by opacity.
struct PixelStateFragment {
    float depth = 0, view_depth = 0, window_depth = 0, plane_depth = 0;
    float opacity = 0;
    float red = 0, green = 0, blue = 0;
    std::uint32_t seed = 0;
    float threshold = 0;
};

/// The colour of all fragments as far as it is seen, and the total transmittance.
struct Composited {
    float red = 0, green = 0, blue = 0;
    float transmittance = 1;
};

/// How the states of fragments are accumulated (shaders/shared/pixel_state.glsl).
enum class Accumulation { sum, over, ordered, samples, nearest };

/// A parameter that the mathematics reads, and its type there.
struct PixelStateSetting {
    enum class Type { integer, boolean, number };
    ParameterId parameter;
    Type type;
};

/// All functions take ResolvedParameters::settings. No parameter that they read may be `auto`.
struct PixelStateKernel {
    std::span<const PixelStateSetting> settings;  // the macro SETTINGS of the math file, in its order
    Accumulation accumulation;
    bool holds_colors;  // true: one geometry pass; false: a second pass weighs colours by transmittance_at

    PixelState (*empty_state)(const ParameterValues& values);

    /// The state after one more fragment, with the roundings of the accumulation.
    PixelState (*with_fragment)(const PixelState& state, const PixelStateFragment& fragment,
                                const ParameterValues& values);

    /// The transmittance to a fragment. To ask for a depth, pass a fragment of some opacity there. Null if
    /// the technique defines no transmittance as a function of depth, such as plain alpha blending. With some
    /// techniques the result may exceed 1.
    float (*transmittance_at)(const PixelState& state, const PixelStateFragment& fragment,
                              const ParameterValues& values);

    /// Adds a fragment in a second pass that stores states, too. Null for techniques without such a pass.
    /// `read` is what the first pass stored, as returned by `readable`.
    PixelState (*accumulate_second_pass)(const PixelState& state, const PixelState& read,
                                         const PixelStateFragment& fragment, const ParameterValues& values);

    /// The state as later passes read it, in numbers that may be averaged with those of other pixels.
    PixelState (*readable)(const PixelState& state, const ParameterValues& values);

    /// Index of the number that the second pass replaces by the total absorbance of the pixel itself; -1 if
    /// there is none.
    int exact_absorbance_slot;

    bool has_depths() const { return transmittance_at != nullptr; }

    Composited (*composited)(const PixelState& state, const ParameterValues& values);
};

}  // namespace momentscope
