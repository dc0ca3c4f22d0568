// shadow_settings.hpp -- what parameters say about shadows.
#pragma once
#include <optional>

#include "core/scene/scene.hpp"
#include "core/shadow/opaque_shadow.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

constexpr int MAX_SHADOW_RADIUS = 8;

/// Parameters with `auto` replaced.
struct ShadowSettings {
    bool casters = true;        // do transparent ones count?
    Configuration transparent;  // the technique of the transparent casters' map, with the light's beta;
                                // `sorted` for a deep shadow map
    const OpaqueShadow* opaque = nullptr;
    int size = 1024;  // texels of a side
    int radius = 4;   // of the filter, in texels
    Light light;
    std::optional<float> distance;  // of the light from the centre of all casters; nullopt: four radii

    bool deep() const { return casters && transparent.technique->is_truth(); }
};

bool has_shadows(const ParameterValues& values);

/// The technique of the transparent casters' map, and its values: beta is the light's. What else a technique
/// reads, such as theta, is the same for eye and light.
Configuration light_configuration(const ParameterValues& values);

/// The technique whose math a map of opaque casters shares, with b_0 = 1 and beta = 0, in floats: what a plot
/// draws of it. `sorted` where a map shares none.
Configuration opaque_configuration(const ParameterValues& values);

ShadowSettings shadow_settings(const ParameterValues& values, const Light& of_scene);

/// Do both light a receiver alike, wherever the light stands? Parameters that maps do not read, such as
/// renormalisation, do not count.
bool same_lookup(const ShadowSettings& a, const ShadowSettings& b);

/// Numbers that a texel of the transparent casters' map stores, b_0 among them; 0 for a deep shadow map.
int texel_numbers(const Configuration& configuration);

}  // namespace momentscope
