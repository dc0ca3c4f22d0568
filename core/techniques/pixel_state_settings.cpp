#include "core/techniques/pixel_state_settings.hpp"

#include <fmt/format.h>

#include <type_traits>

namespace momentscope {

namespace {

// Members of the uniform block in shaders/passes/blocks.glsl that hold the float settings.
constexpr const char* FRAME_NUMBERS[] = {"frame.parameters.x", "frame.parameters.y"};

template <typename... Members>
std::string glsl_list(const std::tuple<Members...>& members) {
    std::string text;
    std::size_t floats = 0;
    const auto add = [&](auto member) {
        if (!text.empty()) text += ", ";
        if constexpr (std::is_same_v<decltype(member), float>)
            text += FRAME_NUMBERS[floats++];
        else
            text += fmt::format("{}", member);
    };
    std::apply([&](auto... each) { (add(each), ...); }, members);
    return text;
}

}  // namespace

int resolution_divisor(const PixelStateSettings& settings) {
    const auto* moments = std::get_if<MomentTransparencySettings>(&settings);
    return moments != nullptr ? 1 << static_cast<int>(moments->resolution) : 1;
}

int moment_sets(const PixelStateSettings& settings) {
    const auto* moments = std::get_if<MomentTransparencySettings>(&settings);
    return moments != nullptr && moments->moment_passes != MomentSets::one ? 2 : 1;
}

int sample_count(const PixelStateSettings& settings) {
    const auto* stochastic = std::get_if<StochasticSettings>(&settings);
    return stochastic != nullptr ? stochastic->samples : 0;
}

std::string glsl_arguments(const PixelStateSettings& settings) {
    return std::visit([](const auto& each) { return glsl_list(each.shared()); }, settings);
}

}  // namespace momentscope
