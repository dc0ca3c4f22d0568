#include "core/render/moment_passes.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/gl/texture.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

void begin_additive(const GlFramebuffer& target, int color_count) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    const float zero[4] = {0, 0, 0, 0};
    for (int i = 0; i < color_count; ++i) glClearNamedFramebufferfv(target, GL_COLOR, i, zero);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
}

void end_additive() {
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace

ShaderVariant moment_variant(const Technique& technique) {
    return {.defines = {{"MOMENT_COUNT", std::to_string(technique.moment_count)}},
            .technique = fmt::format("shared/{}_moments.glsl", technique.basis)};
}

MomentPasses::MomentPasses(const Technique& technique, glm::ivec2 size, GLuint depth)
    : technique_(technique) {
    const int floats = technique.kernel->moment_floats;
    total_absorbance_ = make_texture(GL_R32F, size);
    moments_1_to_4_ = make_texture(GL_RGBA32F, size);
    if (floats > 4) moments_5_to_8_ = make_texture(floats > 6 ? GL_RGBA32F : GL_RG32F, size);
    weighted_color_ = make_texture(GL_RGBA16F, size);  // half floats, as in the paper's evaluation
    const GLuint targets[] = {total_absorbance_, moments_1_to_4_, moments_5_to_8_};
    moment_target_ = make_framebuffer(targets, floats > 4 ? 3 : 2, depth);
    color_target_ = make_framebuffer({weighted_color_}, depth);
    const ShaderVariant variant = moment_variant(technique);
    moment_program_ = link_program("passes/scene.vert", "passes/moments.frag", variant);
    color_program_ = link_program("passes/scene.vert", "passes/color.frag", variant);
    composite_program_ = link_program("passes/fullscreen.vert", "passes/composite.frag");
}

void MomentPasses::draw_moments(const PassInput& input) {
    begin_additive(moment_target_, moments_5_to_8_ != 0 ? 3 : 2);
    glUseProgram(moment_program_);
    input.scene.draw(Surfaces::transparent);
    end_additive();
}

void MomentPasses::draw_color(const PassInput& input) {
    begin_additive(color_target_, 1);
    glUseProgram(color_program_);
    bind_moments();
    input.scene.draw(Surfaces::transparent);
    end_additive();
}

void MomentPasses::draw_composite(const PassInput& input) {
    glUseProgram(composite_program_);
    glBindTextureUnit(0, input.opaque_color);
    glBindTextureUnit(1, weighted_color_);
    glBindTextureUnit(2, total_absorbance_);
    draw_fullscreen();
}

bool MomentPasses::draw_failures(const PassInput& input) {
    if (failure_program_ == 0)
        failure_program_ =
            link_program("passes/scene.vert", "passes/failures.frag", moment_variant(technique_));
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(failure_program_);
    bind_moments();
    input.scene.draw(Surfaces::transparent);
    end_additive();
    return true;
}

bool MomentPasses::bind_for_capture() const {
    bind_moments();
    return true;
}

void MomentPasses::bind_moments() const {
    glBindTextureUnit(0, total_absorbance_);
    glBindTextureUnit(1, moments_1_to_4_);
    glBindTextureUnit(2, moments_5_to_8_);
}

}  // namespace momentscope
