// shadow_settings.hpp -- the settings of shadows, which follow from parameters.
#pragma once
#include <optional>

#include "core/scene/scene.hpp"
#include "core/shadow/opaque_shadow.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

constexpr int MAX_SHADOW_RADIUS = 8;

/// The parameters of shadows, mostly with `auto` replaced.
struct ShadowSettings {
    bool casters = true;        // do transparent casters count?
    Configuration transparent;  // of the map of transparent casters, with the beta of the light;
                                // `sorted` for a deep shadow map
    const OpaqueShadow* opaque = nullptr;
    int size = 1024;  // texels along a side
    int radius = 4;   // of the filter, in texels
    Light light;
    std::optional<float> distance;  // of the light from the centre of all casters; nullopt: four radii

    bool deep() const { return casters && transparent.technique->is_truth(); }
};

bool has_shadows(const ParameterValues& values);

/// The technique of the map of transparent casters, and its parameters. beta is that of the light. Other
/// parameters of a technique, such as theta, are the same for eye and light.
Configuration light_configuration(const ParameterValues& values);

/// The technique with the same mathematics as the map of opaque casters, with b_0 = 1 and beta = 0, in
/// floats. Plots of the map draw it. `sorted` if there is no such technique.
Configuration opaque_configuration(const ParameterValues& values);

ShadowSettings shadow_settings(const ParameterValues& values, const Light& of_scene);

/// True if both settings light a receiver alike, whatever the place of the light. Parameters that maps do not
/// read, such as renormalisation, do not count.
bool same_lookup(const ShadowSettings& a, const ShadowSettings& b);

/// How many numbers a texel of the map of transparent casters stores, with b_0; 0 for a deep shadow map.
int texel_numbers(const Configuration& configuration);

}  // namespace momentscope
