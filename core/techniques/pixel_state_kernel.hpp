// pixel_state_kernel.hpp -- one technique without moments as C++ functions: what shaders/shared says,
// compiled for the CPU.
#pragma once
#include <array>
#include <cstdint>

#include "core/techniques/pixel_state_settings.hpp"

namespace momentscope {

constexpr int STATE_CAPACITY = 68;

/// What a pixel stores; the math file of the technique says what which number is.
struct PixelState {
    std::array<float, STATE_CAPACITY> f{};
};

/// shaders/shared/pixel_state.glsl. Depth in [0, 1] of the depth range; colour not multiplied by opacity.
struct PixelStateFragment {
    float depth = 0, view_depth = 0, window_depth = 0, plane_depth = 0;
    float opacity = 0;
    float red = 0, green = 0, blue = 0;
    std::uint32_t seed = 0;
    float threshold = 0;
};

/// Colour of all fragments as far as it is seen, and the transmittance of all.
struct Composited {
    float red = 0, green = 0, blue = 0;
    float transmittance = 1;
};

/// How states of fragments come together (shaders/shared/pixel_state.glsl).
enum class Accumulation { sum, over, ordered, samples, nearest };

struct PixelStateKernel {
    Accumulation accumulation;
    bool holds_colors;  // one geometry pass; else a second one weighs colours by transmittance_at

    PixelState (*empty_state)(const PixelStateSettings& settings);

    /// The state after one more fragment, with the roundings of its accumulation.
    PixelState (*with_fragment)(const PixelState& state, const PixelStateFragment& fragment,
                                const PixelStateSettings& settings);

    /// Of a fragment, or of a depth with a fragment's opacity. Null if the technique defines no transmittance
    /// as a function of depth, such as plain alpha blending. Some techniques exceed 1.
    float (*transmittance_at)(const PixelState& state, const PixelStateFragment& fragment,
                              const PixelStateSettings& settings);

    /// Adds a fragment in a second pass that stores states too; null for techniques without such a pass.
    /// `read` is what the first pass stored, as `readable` gives it.
    PixelState (*accumulate_second_pass)(const PixelState& state, const PixelState& read,
                                         const PixelStateFragment& fragment,
                                         const PixelStateSettings& settings);

    /// The state as later passes read it, in the numbers that may be mixed with those of other pixels.
    PixelState (*readable)(const PixelState& state, const PixelStateSettings& settings);

    /// Which number the second pass replaces by the pixel's own total absorbance; -1 for none.
    int exact_absorbance_slot;

    bool has_depths() const { return transmittance_at != nullptr; }

    Composited (*composited)(const PixelState& state, const PixelStateSettings& settings);
};

}  // namespace momentscope
