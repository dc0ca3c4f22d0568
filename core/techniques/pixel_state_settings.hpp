// pixel_state_settings.hpp -- the settings of techniques without moments, which follow from parameters: one
// struct for each technique that has settings.
#pragma once
#include <string>
#include <tuple>
#include <variant>

#include "core/parameters/parameter_choices.hpp"

namespace momentscope {

// shared() lists the members of `PixelStateSettings` in the math file of the technique (shaders/shared), in
// their order there. Kernels and shaders get these values. Shaders read floats from a uniform block, so that
// dragging a slider compiles no shader. If a technique has floats, these are the overestimation weight and
// the moment bias, in this order.

/// For techniques without settings.
struct NoSettings {
    friend bool operator==(const NoSettings&, const NoSettings&) = default;
    auto shared() const { return std::tuple(0); }
};

struct WeightedSettings {
    WeightFunction weight = WeightFunction::window_depth;
    friend bool operator==(const WeightedSettings&, const WeightedSettings&) = default;
    auto shared() const { return std::tuple(static_cast<int>(weight)); }
};

struct FourierSettings {
    int frequencies = 3;  // K: the series has 2K + 1 real coefficients
    bool lanczos = false;
    friend bool operator==(const FourierSettings&, const FourierSettings&) = default;
    auto shared() const { return std::tuple(frequencies, lanczos); }
};

struct MomentTransparencySettings {
    ReadFormat read_format = ReadFormat::floats;
    MomentSets moment_passes = MomentSets::one;
    DepthRange depth_range = DepthRange::corrected;
    float overestimation = 0.25f;
    float bias = 0;
    MomentResolution resolution = MomentResolution::full;
    friend bool operator==(const MomentTransparencySettings&, const MomentTransparencySettings&) = default;
    auto shared() const {
        return std::tuple(static_cast<int>(read_format), static_cast<int>(moment_passes),
                          static_cast<int>(depth_range), overestimation, bias);
    }
};

struct StochasticSettings {
    int samples = 8;
    bool alpha_correction = true;
    friend bool operator==(const StochasticSettings&, const StochasticSettings&) = default;
    auto shared() const { return std::tuple(samples, alpha_correction); }
};

struct AdaptiveSettings {
    int nodes = 4;
    friend bool operator==(const AdaptiveSettings&, const AdaptiveSettings&) = default;
    auto shared() const { return std::tuple(nodes); }
};

struct LayeredSettings {
    int layers = 4;
    LayerBits bits = LayerBits::bits_16;
    friend bool operator==(const LayeredSettings&, const LayeredSettings&) = default;
    auto shared() const { return std::tuple(layers, static_cast<int>(bits)); }
};

using PixelStateSettings =
    std::variant<NoSettings, WeightedSettings, FourierSettings, MomentTransparencySettings,
                 StochasticSettings, AdaptiveSettings, LayeredSettings>;

/// How many pixels a texel of the moments covers in each direction; 1 for techniques with one resolution.
int resolution_divisor(const PixelStateSettings& settings);

/// How many sets of moments a pixel stores; 1 for techniques that draw their state in one pass.
int moment_sets(const PixelStateSettings& settings);

/// How many samples a pixel has; 0 for techniques without samples.
int sample_count(const PixelStateSettings& settings);

/// The arguments of `PixelStateSettings(...)` in a shader.
std::string glsl_arguments(const PixelStateSettings& settings);

}  // namespace momentscope
