#include "core/render/state_passes.hpp"

#include <fmt/format.h>

#include <bit>
#include <glm/gtc/type_ptr.hpp>

#include "core/gl/buffer.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/support/error.hpp"
#include "core/techniques/quantisation_glsl.hpp"

namespace momentscope {

namespace {

// Texture units, as in passes/stored_state.glsl and state_composite.frag.
constexpr GLuint SAMPLES_UNIT = 3;
constexpr GLuint EXACT_ABSORBANCE_UNIT = 10;
constexpr GLuint OPAQUE_DEPTH_UNIT = 11;  // state.frag

// The arguments of PixelStateSettings(...) in a shader.
std::string settings_text(const PixelStateKernel& kernel, const ParameterValues& values) {
    if (kernel.settings.empty()) return "0";
    std::string text;
    for (const auto& [id, type] : kernel.settings) {
        text += text.empty() ? "" : ", ";
        if (type == PixelStateSetting::Type::boolean)
            text += values.is_on(id) ? "true" : "false";
        else if (type == PixelStateSetting::Type::integer)
            text += fmt::format("{}", values.count(id));
        else  // passes/blocks.glsl
            text += id == ParameterId::beta ? "frame.parameters.x" : "frame.parameters.y";
    }
    return text;
}

// Samples are written by atomic operations; only the absorbance is blended.
Blending blending_of(Accumulation accumulation) {
    if (accumulation == Accumulation::ordered) return Blending::none;
    return accumulation == Accumulation::over ? Blending::over : Blending::add;
}

}  // namespace

int texel_count(const Technique& technique, const ParameterValues& settings) {
    return (technique.pixel_states().floats(settings) + 3) / 4;
}

ShaderVariant state_variant(const Technique& technique, const ParameterValues& settings) {
    ShaderVariant variant = {
        .defines = {{"PIXEL_STATE", "1"},
                    {"PIXEL_STATE_SETTINGS", settings_text(technique.pixel_state_kernel(), settings)},
                    {"SAMPLE_COUNT", std::to_string(sample_count(technique, settings))},
                    {"STATE_TEXELS", std::to_string(texel_count(technique, settings))}},
        .technique = fmt::format("shared/{}.glsl", technique.pixel_states().math_file)};
    if (resolution_divisor(technique, settings) > 1) variant.defines["LOW_RESOLUTION"] = "1";
    if (technique.uses(ParameterId::read_format)) variant.constants = quantisation_glsl(4);
    return variant;
}

ShaderVariant state_building_variant(const Technique& technique, const ParameterValues& settings,
                                     OrderedAccess access) {
    ShaderVariant variant = state_variant(technique, settings);
    define_access(variant, access);
    return variant;
}

StatePasses::StatePasses(const Technique& technique, glm::ivec2 size, GLuint depth, const Capabilities& gl)
    : technique_(technique),
      size_(size),
      depth_(depth),
      most_targets_(gl.color_targets),
      access_(needs_order(technique) ? gl.ordered : OrderedAccess::none) {
    if (const std::string why = why_unavailable(technique, gl); !why.empty())
        throw Error(fmt::format("{} cannot be drawn here. {}", technique.name, why));
    depth_target_ = make_framebuffer({}, depth);
    if (technique.pixel_state_kernel().holds_colors) return;
    weighted_color_ = make_texture(GL_RGBA32F, size);
    if (technique.pixel_state_kernel().exact_absorbance_slot < 0) {
        color_target_ = make_framebuffer({weighted_color_}, depth);
    } else {
        exact_absorbance_ = make_texture(GL_RGBA32F, size);
        color_target_ = make_framebuffer({weighted_color_, exact_absorbance_}, depth);
    }
}

// The number of numbers that a pixel stores depends on parameters.
void StatePasses::make_states(const ParameterValues& settings) {
    const auto count = static_cast<std::size_t>(texel_count(technique_, settings));
    settings_ = settings;
    if (technique_.pixel_state_kernel().accumulation == Accumulation::samples)
        make_samples(sample_count(technique_, settings));
    if (states_.size() == count) return;
    if (access_ == OrderedAccess::framebuffer_fetch && count > static_cast<std::size_t>(most_targets_))
        throw Error(fmt::format(
            "{} reads and writes {} colour targets at once here, but this GL has {}; set --layers lower.",
            technique_.name, count, most_targets_));
    states_.clear();
    for (std::size_t i = 0; i < count; ++i) states_.push_back(make_texture(GL_RGBA32F, size_));
    GLuint depth = depth_;
    if (technique_.pixel_state_kernel().accumulation == Accumulation::nearest)
        depth = nearest_depth_ = make_texture(GL_DEPTH_COMPONENT32F, size_);
    state_targets_ = make_group_framebuffers(states_, depth, most_targets_);
}

void StatePasses::make_samples(int count) {
    if (sample_count_ == count) return;
    const int most = most_texture_layers();
    if (count > most)
        throw Error(
            fmt::format("This GL has textures of at most {} layers; choose at most as many samples.", most));
    samples_ = make_layered_texture(GL_R32UI, size_, count);
    sample_targets_.clear();
    for (int i = 0; i < count; ++i) sample_targets_.push_back(make_layer_framebuffer(samples_, i, 1));
    sample_count_ = count;
}

void StatePasses::clear_states() const {
    const PixelState empty = technique_.pixel_state_kernel().empty_state(settings_);
    const auto group = static_cast<std::size_t>(most_targets_);
    for (std::size_t i = 0; i < states_.size(); ++i)
        clear_color(state_targets_[i / group], static_cast<int>(i % group), glm::make_vec4(&empty.f[4 * i]));
    for (const GlFramebuffer& target : sample_targets_)
        clear_color(target, 0, glm::uvec4(std::bit_cast<std::uint32_t>(empty.f[1])));
    if (nearest_depth_ != 0) clear_depth(state_targets_.front(), 1);
}

void StatePasses::draw_moments(const PassInput& input) {
    make_states(input.parameters.settings);
    clear_states();
    // Images need no groups: all states are changed in one pass.
    const bool by_images = access_ == OrderedAccess::interlock;
    for (std::size_t i = 0; i < (by_images ? 1 : state_targets_.size()); ++i) {
        ShaderVariant variant = input.lean(input.lit(state_building_variant(technique_, settings_, access_)));
        if (!by_images) define_group(variant, i, states_.size(), most_targets_);
        use_program(input.programs.get("passes/scene.vert", "passes/state.frag", variant));
        draw_states(input, state_targets_[i]);
    }
}

void StatePasses::draw_states(const PassInput& input, GLuint target) const {
    if (technique_.pixel_state_kernel().accumulation == Accumulation::nearest) {
        bind_texture(OPAQUE_DEPTH_UNIT, depth_);
        draw_nearest(input.scene, target);
        return;
    }
    if (samples_ != 0) bind_image(0, samples_, GL_R32UI);
    const bool by_images = access_ == OrderedAccess::interlock;
    for (std::size_t i = 0; by_images && i < states_.size(); ++i)
        bind_image(static_cast<GLuint>(i), states_[i], GL_RGBA32F);
    draw_transparent(input.scene, by_images ? depth_target_ : target,
                     {.blending = blending_of(technique_.pixel_state_kernel().accumulation)});
    if (by_images || samples_ != 0) finish_shader_writes();
}

void StatePasses::draw_color(const PassInput& input) {
    settings_ = input.parameters.settings;  // parameters may have changed that do not change states
    if (technique_.pixel_state_kernel().holds_colors) return;
    clear_colors(color_target_, exact_absorbance_ != 0 ? 2 : 1);
    use_program(input.programs.get("passes/scene.vert", "passes/state_color.frag",
                                   input.lean(input.lit(state_variant(technique_, settings_)))));
    bind_states();
    draw_transparent(input.scene, color_target_, {.blending = Blending::add});
}

void StatePasses::draw_composite(const PassInput& input, GLuint target) {
    settings_ = input.parameters.settings;  // parameters may have changed that do not change weights
    set_draw_state({});
    bind_framebuffer(target);
    use_program(input.programs.get("passes/fullscreen.vert", "passes/state_composite.frag",
                                   state_variant(technique_, settings_)));
    bind_texture(0, input.opaque_color);
    bind_texture(1, weighted_color_);
    bind_texture(EXACT_ABSORBANCE_UNIT, exact_absorbance_);
    bind_states();
    draw_fullscreen();
}

std::optional<ShaderVariant> StatePasses::bind_for_capture(const ResolvedParameters& parameters) const {
    if (!technique_.pixel_state_kernel().has_depths()) return std::nullopt;
    bind_states();
    return state_variant(technique_, parameters.settings);
}

void StatePasses::bind_states() const {
    for (std::size_t i = 0; i < states_.size(); ++i)
        bind_texture(FIRST_STATE_UNIT + static_cast<GLuint>(i), states_[i]);
    if (samples_ != 0) bind_layered_texture(SAMPLES_UNIT, samples_);
}

}  // namespace momentscope
