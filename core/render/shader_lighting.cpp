#include "core/render/shader_lighting.hpp"

#include <fmt/format.h>

#include "core/render/moment_passes.hpp"
#include "core/render/state_passes.hpp"
#include "core/techniques/quantisation_glsl.hpp"

namespace momentscope {

namespace {

ShaderNamespace opaque_namespace(const OpaqueShadow& row) {
    return {.defines = {{"MOMENT_COUNT", std::to_string(row.moment_count)},
                        {"MOMENT_BITS", std::to_string(row.bits)}},
            .technique = fmt::format("shared/{}.glsl", row.math_file),
            .constants = row.bits == 16 ? quantisation_glsl(row.moment_count) : ""};
}

ShaderNamespace transparent_namespace(const Configuration& transparent) {
    const Technique& technique = *transparent.technique;
    ShaderVariant variant = technique.has_moments()
                                ? moment_variant(technique)
                                : state_variant(technique, resolve(transparent.values, technique).settings);
    return {std::move(variant.defines), std::move(variant.technique), std::move(variant.constants)};
}

}  // namespace

int caster_layers(const ShadowSettings& settings) {
    return (texel_numbers(settings.transparent) + 3) / 4;
}

ShaderLighting shader_lighting(const ShadowSettings& settings) {
    ShaderLighting lighting = {.defines = {{"SHADOWS", "1"}},
                               .namespaces = {{"opaque", opaque_namespace(*settings.opaque)}}};
    if (!settings.casters) {
        lighting.defines["NO_TRANSPARENT_CASTERS"] = "1";
    } else if (settings.deep()) {
        lighting.defines["DEEP_SHADOWS"] = "1";
    } else {
        lighting.defines["CASTER_LAYERS"] = std::to_string(caster_layers(settings));
        lighting.namespaces["transparent"] = transparent_namespace(settings.transparent);
    }
    return lighting;
}

void add_lighting(ShaderVariant& variant, const ShaderLighting& lighting) {
    variant.defines.insert(lighting.defines.begin(), lighting.defines.end());
    variant.namespaces.insert(lighting.namespaces.begin(), lighting.namespaces.end());
}

}  // namespace momentscope
