// shader_lighting.hpp -- the part of a shader variant that belongs to the light: the variant of
// passes/light.glsl.
#pragma once
#include "core/gl/program.hpp"
#include "core/shadow/shadow_settings.hpp"

namespace momentscope {

/// What is added to a shader variant if surfaces receive shadows.
struct ShaderLighting {
    std::map<std::string, std::string> defines;
    std::map<std::string, ShaderNamespace> namespaces;
    friend bool operator==(const ShaderLighting&, const ShaderLighting&) = default;
};

ShaderLighting shader_lighting(const ShadowSettings& settings);

void add_lighting(ShaderVariant& variant, const ShaderLighting& lighting);

/// The groups of four numbers in a texel of the map of transparent casters; 0 for a deep map.
int caster_layers(const ShadowSettings& settings);

}  // namespace momentscope
