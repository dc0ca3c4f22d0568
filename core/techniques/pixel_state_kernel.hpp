// pixel_state_kernel.hpp -- one technique without moments as C++ functions: what shaders/shared says,
// compiled for the CPU.
#pragma once
#include <array>
#include <cstdint>

namespace momentscope {

constexpr int STATE_CAPACITY = 68;

/// What a pixel stores; the math file of the technique says what which number is.
struct PixelState {
    std::array<float, STATE_CAPACITY> f{};
};

/// Which variant of a technique: how many nodes, layers, samples or frequencies, and the choices of
/// parameters.
struct PixelStateSettings {
    int size = 0;
    int option = 0;
    float overestimation = 0.25f;  // of techniques that have moments, too, as is
    float bias = 0;
    int divisor = 1;  // of the picture's resolution, which that of the moments is
    friend bool operator==(const PixelStateSettings&, const PixelStateSettings&) = default;
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

    /// Of a fragment, or of a depth with a fragment's opacity; null where it is none of depth, as of
    /// fragments that are put over each other. Not bounded by 1 for every technique.
    float (*transmittance_at)(const PixelState& state, const PixelStateFragment& fragment,
                              const PixelStateSettings& settings);

    /// Where a second geometry pass adds to the state what it makes of the first one's; else null. `read` is
    /// what the first one stored, filterable.
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
