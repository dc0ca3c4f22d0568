#include "core/render/state_passes.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

namespace {

constexpr GLuint FIRST_STATE_UNIT = 2;  // passes/stored_state.glsl

int texel_count(const Technique& technique, const MethodSettings& settings) {
    return (technique.state_floats(settings) + 3) / 4;
}

Blending blending_of(Accumulation accumulation) {
    if (accumulation == Accumulation::ordered) return Blending::none;
    return accumulation == Accumulation::over ? Blending::over : Blending::add;
}

}  // namespace

ShaderVariant state_variant(const Technique& technique, const MethodSettings& settings) {
    return {.defines = {{"PIXEL_STATE", "1"},
                        {"METHOD_SIZE", std::to_string(settings.size)},
                        {"METHOD_OPTION", std::to_string(settings.option)},
                        {"STATE_TEXELS", std::to_string(texel_count(technique, settings))}},
            .technique = fmt::format("shared/{}.glsl", technique.math_file)};
}

ShaderVariant state_building_variant(const Technique& technique, const MethodSettings& settings,
                                     OrderedAccess access) {
    ShaderVariant variant = state_variant(technique, settings);
    define_access(variant, access);
    return variant;
}

StatePasses::StatePasses(const Technique& technique, glm::ivec2 size, GLuint depth, OrderedAccess access)
    : technique_(technique),
      size_(size),
      depth_(depth),
      access_(needs_order(technique) ? access : OrderedAccess::none) {
    if (const std::string why = why_unavailable(technique, access); !why.empty())
        throw Error(fmt::format("{} cannot be drawn here. {}", technique.name, why));
    depth_target_ = make_framebuffer({}, depth);
    if (technique.method->holds_colors) return;
    weighted_color_ = make_texture(GL_RGBA32F, size);
    color_target_ = make_framebuffer({weighted_color_}, depth);
}

// How many numbers a pixel stores depends on parameters.
void StatePasses::make_states(const MethodSettings& settings) {
    const auto count = static_cast<std::size_t>(texel_count(technique_, settings));
    settings_ = settings;
    if (states_.size() == count) return;
    states_.clear();
    std::vector<GLuint> names;
    for (std::size_t i = 0; i < count; ++i) {
        states_.push_back(make_texture(GL_RGBA32F, size_));
        names.push_back(states_.back());
    }
    state_target_ = make_framebuffer(names.data(), static_cast<int>(count), depth_);
}

void StatePasses::clear_states() const {
    const PixelState empty = technique_.method->empty_state(settings_);
    for (std::size_t i = 0; i < states_.size(); ++i)
        glClearNamedFramebufferfv(state_target_, GL_COLOR, static_cast<GLint>(i), &empty.f[4 * i]);
}

void StatePasses::draw_moments(const PassInput& input) {
    make_states(input.parameters.method);
    clear_states();
    const bool by_images = access_ == OrderedAccess::interlock;
    for (std::size_t i = 0; by_images && i < states_.size(); ++i)
        glBindImageTexture(static_cast<GLuint>(i), states_[i], 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glUseProgram(programs_.get("passes/scene.vert", "passes/state.frag",
                               state_building_variant(technique_, settings_, access_)));
    draw_transparent(input.scene, by_images ? depth_target_ : state_target_,
                     blending_of(technique_.method->accumulation));
    if (by_images) glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void StatePasses::draw_color(const PassInput& input) {
    settings_ = input.parameters.method;  // an option may have changed that stores nothing
    if (technique_.method->holds_colors) return;
    clear_colors(color_target_, 1);
    glUseProgram(
        programs_.get("passes/scene.vert", "passes/state_color.frag", state_variant(technique_, settings_)));
    bind_states();
    draw_transparent(input.scene, color_target_, Blending::add);
}

void StatePasses::draw_composite(const PassInput& input) {
    glUseProgram(programs_.get("passes/fullscreen.vert", "passes/state_composite.frag",
                               state_variant(technique_, settings_)));
    glBindTextureUnit(0, input.opaque_color);
    glBindTextureUnit(1, weighted_color_);
    bind_states();
    draw_fullscreen();
}

std::optional<ShaderVariant> StatePasses::bind_for_capture(const ResolvedParameters& parameters) const {
    if (!technique_.method->has_depths()) return std::nullopt;
    bind_states();
    return state_variant(technique_, parameters.method);
}

void StatePasses::bind_states() const {
    for (std::size_t i = 0; i < states_.size(); ++i)
        glBindTextureUnit(FIRST_STATE_UNIT + static_cast<GLuint>(i), states_[i]);
}

}  // namespace momentscope
