// shader_lighting.hpp -- how shaders are told of a light: the variant of passes/light.glsl.
#pragma once
#include "core/gl/program.hpp"
#include "core/shadow/shadow_settings.hpp"

namespace momentscope {

/// What a shader variant has more where surfaces receive shadows.
struct ShaderLighting {
    std::map<std::string, std::string> defines;
    std::map<std::string, ShaderNamespace> namespaces;
    friend bool operator==(const ShaderLighting&, const ShaderLighting&) = default;
};

ShaderLighting shader_lighting(const ShadowSettings& settings);

void add_lighting(ShaderVariant& variant, const ShaderLighting& lighting);

/// Groups of four numbers of a texel of the transparent casters' map; 0 for a deep one.
int caster_layers(const ShadowSettings& settings);

}  // namespace momentscope
