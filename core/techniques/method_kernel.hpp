// method_kernel.hpp -- one technique without moments as C++ functions: what shaders/shared says, compiled for
// the CPU.
#pragma once
#include <array>

namespace momentscope {

constexpr int STATE_CAPACITY = 32;

/// What a pixel stores; the math file of the technique says what which number is.
struct PixelState {
    std::array<float, STATE_CAPACITY> f{};
};

/// Which variant of a technique: how many nodes, layers or frequencies, and the choice of a parameter.
struct MethodSettings {
    int size = 0;
    int option = 0;
    friend bool operator==(const MethodSettings&, const MethodSettings&) = default;
};

/// shaders/shared/pixel_state.glsl. Depth in [0, 1] of the depth range; colour not multiplied by opacity.
struct MethodFragment {
    float depth = 0, view_depth = 0, window_depth = 0;
    float opacity = 0;
    float red = 0, green = 0, blue = 0;
};

/// Colour of all fragments as far as it is seen, and the transmittance of all.
struct Composited {
    float red = 0, green = 0, blue = 0;
    float transmittance = 1;
};

/// How states of fragments come together: summed, put over what is there, or one after the other.
enum class Accumulation { sum, over, ordered };

struct MethodKernel {
    Accumulation accumulation;
    bool holds_colors;  // one geometry pass; else a second one weighs colours by transmittance_at

    PixelState (*empty_state)(const MethodSettings& settings);

    /// The state after one more fragment, with the roundings of its accumulation.
    PixelState (*with_fragment)(const PixelState& state, const MethodFragment& fragment,
                                const MethodSettings& settings);

    /// Of a fragment, or of a depth with a fragment's opacity; null where it is none of depth, as of
    /// fragments that are put over each other. Not bounded by 1 for every technique.
    float (*transmittance_at)(const PixelState& state, const MethodFragment& fragment,
                              const MethodSettings& settings);

    bool has_depths() const { return transmittance_at != nullptr; }

    Composited (*composited)(const PixelState& state, const MethodSettings& settings);
};

}  // namespace momentscope
