// shader_writer.cpp -- writes every shader of every technique, expanded, into a folder, for linting.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/gl/program.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/moment_passes.hpp"
#include "core/render/shader_lighting.hpp"
#include "core/render/state_passes.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace {

using namespace momentscope;

constexpr const char* PLAIN[] = {
    "passes/scene.vert",        "passes/fullscreen.vert",     "passes/opaque.frag",
    "passes/composite.frag",    "passes/display.frag",        "passes/capture.frag",
    "passes/sorted.frag",       "passes/peel.frag",           "passes/peel_composite.frag",
    "passes/copy.frag",         "passes/failure_colors.frag", "passes/farthest_depth.frag",
    "passes/caster_depth.frag", "passes/shadow_filter.frag",  "passes/peel_depth.frag",
    "passes/peel_ties.frag",    "passes/rounding_check.frag"};
constexpr const char* RECONSTRUCTING[] = {"passes/color.frag", "passes/capture.frag", "passes/failures.frag",
                                          "passes/uncertainty.frag"};

// Only GLSL 4.50 writes lists and images.
bool needs_storage(const std::string& path, const ShaderVariant& variant) {
    for (const char* file : {"passes/sorted.frag", "tests/evaluate.comp", "tests/evaluate.frag"})
        if (path == file) return true;
    return (path == "passes/capture.frag" && !variant.defines.contains("LAYERED")) ||
           variant.defines.contains("INTERLOCK") ||
           (path == "passes/state.frag" && variant.technique == "shared/stochastic.glsl");
}

bool thorough() {
    const char* text = std::getenv("MOMENTSCOPE_THOROUGH");
    return text != nullptr && std::string_view(text) == "1";
}

// Writes a variant in every dialect that it claims. In GLSL 4.50 also with its loops as they are.
void write(const std::filesystem::path& folder, const std::string& prefix, const std::string& path,
           const ShaderVariant& variant) {
    const std::string name = std::filesystem::path(path).filename().string();
    for (const DialectRow& dialect : dialects()) {
        if (!dialect.has_storage && needs_storage(path, variant)) continue;
        // GLSL 3.30 is the text of 4.10 with the guards of ESSL.
        if (dialect.dialect == Dialect::glsl_330 && !thorough()) continue;
        ShaderLanguage language = language_of(dialect.dialect);
        if (language.rounding == Rounding::unguarded) language.rounding = Rounding::guarded;
        const ShaderText text = shader_text(path, variant, language);
        // glslang takes the stage from the end of the name.
        write_file(text.text, folder / fmt::format("{}.{}.{}", prefix, dialect.key, name));
        if (text.loops_left > 0)
            throw Error(fmt::format("{} {} keeps {} loops.", prefix, name, text.loops_left));
        if (dialect.dialect == Dialect::glsl_450 && !text.with_loops.empty())
            write_file(text.with_loops, folder / fmt::format("{}.loops.{}", prefix, name));
    }
    if (path != "passes/capture.frag" || variant.defines.contains("LAYERED")) return;
    ShaderVariant layered = variant;
    layered.defines["LAYERED"] = layered.defines["NO_PRIMITIVE_IDS"] = "1";
    write(folder, prefix + ".layered", path, layered);
}

// glslangValidator supports framebuffer fetch only in OpenGL ES, so only GLs that have it compile that
// variant.
void write_technique(const std::filesystem::path& folder, const Technique& technique) {
    const std::string id = technique.id;
    ResolvedParameters parameters = resolve({}, technique);
    for (const bool textbook : {false, true}) {
        if (textbook && !technique.uses(ParameterId::solver)) continue;
        parameters.factored_once = false;
        parameters.textbook = textbook;
        ShaderVariant variant = reconstruction_variant(technique, parameters);
        variant.defines["WITH_TRANSMITTANCE"] = "1";
        for (const char* path : RECONSTRUCTING)
            write(folder, id + (textbook ? ".textbook" : ""), path, variant);
    }
    for (const char* path : {"tests/evaluate.comp", "tests/evaluate.frag"})
        write(folder, id, path, moment_variant(technique));
    write(folder, id, "passes/factor.frag", factor_variant(technique, parameters));
    if (pixel_factor_floats(technique, parameters) > 16) {
        ShaderVariant rest = factor_variant(technique, parameters);
        define_group(rest, 1, 5, 4);
        write(folder, id + ".rest", "passes/factor.frag", rest);
    }
    parameters.textbook = false;
    parameters.factored_once = true;
    ShaderVariant factored = reconstruction_variant(technique, parameters);
    factored.defines["WITH_TRANSMITTANCE"] = "1";
    for (const char* path : {"passes/color.frag", "passes/capture.frag"})
        write(folder, id + ".factored", path, factored);
    factored.defines["NO_ALPHA_MAPS"] = "1";
    if (parameters.moves_uncertain()) factored.defines["UNCERTAIN"] = "1";
    write(folder, id + ".lean", "passes/color.frag", factored);
    Capabilities gl;
    gl.ordered = OrderedAccess::interlock;
    parameters.ordered = true;
    write(folder, id + ".ordered", "passes/moments.frag", accumulation_variant(technique, parameters, gl));
    parameters.ordered = false;
    if (technique.moment_kernel().bits != 32) return;
    for (const bool per_target : {false, true}) {
        gl.blending_per_target = per_target;
        write(folder, id + (per_target ? "" : ".apart"), "passes/moments.frag",
              accumulation_variant(technique, parameters, gl));
    }
}

void write_pixel_state(const std::filesystem::path& folder, const Technique& technique) {
    const ParameterValues settings = resolve(ParameterValues(), technique).settings;
    const OrderedAccess access = needs_order(technique) ? OrderedAccess::interlock : OrderedAccess::none;
    ShaderVariant building = state_building_variant(technique, settings, access);
    write(folder, technique.id, "passes/state.frag", building);
    if (access == OrderedAccess::none && texel_count(technique, settings) > 4) {
        define_group(building, 1, static_cast<std::size_t>(texel_count(technique, settings)), 4);
        write(folder, std::string(technique.id) + ".rest", "passes/state.frag", building);
    }
    ShaderVariant variant = state_variant(technique, settings);
    write(folder, technique.id, "passes/state_composite.frag", variant);
    if (!technique.pixel_state_kernel().holds_colors)
        write(folder, technique.id, "passes/state_color.frag", variant);
    if (technique.pixel_state_kernel().accumulate_second_pass != nullptr) {
        write(folder, technique.id, "passes/state_convert.frag", variant);
        ShaderVariant second = state_building_variant(technique, settings, access);
        second.defines.insert({{"SECOND_PASS", "1"}, {"FIRST_TEXEL", "2"}, {"WRITTEN_TEXELS", "2"}});
        write(folder, std::string(technique.id) + ".second", "passes/state.frag", second);
        variant.defines["LOW_RESOLUTION"] = "1";
        write(folder, std::string(technique.id) + ".low", "passes/state_color.frag", variant);
    }
    variant.defines["WITH_TRANSMITTANCE"] = "1";
    if (technique.pixel_state_kernel().has_depths())
        write(folder, technique.id, "passes/capture.frag", variant);
}

// Passes with any light, and passes that draw the light's maps.
void write_shadows(const std::filesystem::path& folder, ParameterId id) {
    const Parameter& row = parameter(id);
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const ShadowSettings settings = shadow_settings(values_with({{id, static_cast<float>(i)}}), {});
        const std::string name = fmt::format("lit.{}", row.choices[i]);
        const auto lit = [&](ShaderVariant variant) {
            add_lighting(variant, shader_lighting(settings));
            return variant;
        };
        for (const char* path : {"passes/opaque.frag", "passes/light_probe.frag", "passes/peel.frag"})
            write(folder, name, path, lit({}));
        write(folder, name, "passes/capture.frag", lit({.defines = {{"WITH_LIGHT", "1"}}}));
        write(folder, name, "passes/color.frag",
              lit(reconstruction_variant(require_technique("trig3-32"), {.factored_once = true})));
        if (caster_layers(settings) > 0) write(folder, name, "passes/caster.frag", lit({}));
        write(folder, name + ".depths", "passes/shadow_filter.frag",
              lit({.defines = {{"OPAQUE_DEPTHS", "1"}}}));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    try {
        for (const char* path : PLAIN) write(argv[1], "plain", path, {});
        write(argv[1], "uncertain", "passes/composite.frag", {.defines = {{"UNCERTAIN", "1"}}});
        write(argv[1], "known", "passes/ends.frag", {.defines = {{"KNOWN_ENDS", "1"}}});
        write(argv[1], "lean", "passes/ends.frag", {.defines = {{"NO_ALPHA_MAPS", "1"}}});
        for (const Technique& technique : techniques()) {
            if (technique.has_moments()) write_technique(argv[1], technique);
            if (technique.has_pixel_states()) write_pixel_state(argv[1], technique);
        }
        for (const ParameterId id : {ParameterId::shadow_technique, ParameterId::opaque_shadow})
            write_shadows(argv[1], id);
    } catch (const Error& error) {
        std::fputs(fmt::format("momentscope_shaders: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
}
