// renderer_light.cpp -- what lights the points that the last picture shows.
#include <cassert>
#include <glm/gtc/matrix_transform.hpp>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/camera.hpp"

namespace momentscope {

glm::vec3 Renderer::world_place(glm::ivec2 pixel, float view_depth) const {
    const glm::vec2 size(view_.size);
    const glm::mat4 projection = projection_matrix(view_.camera, size.x / size.y);
    const glm::vec2 place((static_cast<float>(pixel.x) + 0.5f) / size.x * 2 - 1,
                          1 - (static_cast<float>(pixel.y) + 0.5f) / size.y * 2);
    const glm::dvec4 eye(place.x * view_depth / projection[0][0], place.y * view_depth / projection[1][1],
                         -view_depth, 1);
    return {glm::inverse(glm::dmat4(view_matrix(view_.camera))) * eye};
}

ShadowFilterSamples Renderer::capture_light(glm::ivec2 pixel, float view_depth) {
    assert(lit() && "the picture has no shadows");
    const ShadowMapPosition place =
        light_place(shadow_maps_->frame(), shadow_maps_->settings().size, world_place(pixel, view_depth));
    return shadow_maps_->capture(*buffers_, place);
}

void Renderer::draw_probe() {
    if (probe_ == 0) {
        probe_ = make_texture(GL_RGBA32F, view_.size);
        probe_target_ = make_framebuffer({probe_}, depth_);
    }
    const float nothing[4] = {0, 1, 2, 0};
    glClearNamedFramebufferfv(probe_target_, GL_COLOR, 0, nothing);
    glViewport(0, 0, view_.size.x, view_.size.y);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    shadow_maps_->bind(view_matrix(view_.camera));
    glBindFramebuffer(GL_FRAMEBUFFER, probe_target_);
    glUseProgram(programs_->get("passes/scene.vert", "passes/light_probe.frag", pass_input().lit({})));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    buffers_->draw(Surfaces::opaque);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    leave_nothing_bound();
    probed_ = true;
}

std::optional<Renderer::LitSurface> Renderer::lit_surface(glm::ivec2 pixel) {
    assert(lit() && "the picture has no shadows");
    if (!probed_) draw_probe();
    glm::vec4 probe;
    glGetTextureSubImage(probe_, 0, pixel.x, view_.size.y - 1 - pixel.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                         sizeof(probe), &probe);
    check_gl("reading how a surface is lit");
    if (!(probe.w > 0)) return std::nullopt;
    return LitSurface{probe.w, probe.x, probe.y};
}

std::vector<float> Renderer::fragment_lights(glm::ivec2 pixel) {
    assert(lit() && "the picture has no shadows");
    ShaderVariant variant = pass_input().lit({});
    variant.defines["WITH_LIGHT"] = "1";
    glViewport(0, 0, view_.size.x, view_.size.y);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    shadow_maps_->bind(view_matrix(view_.camera));
    const glm::ivec2 lower_left(pixel.x, view_.size.y - 1 - pixel.y);
    const GLuint program = programs_->get("passes/scene.vert", "passes/capture.frag", variant);
    const std::size_t count = pixel_list_->capture(pass_input(), program, lower_left, {1, 1});
    const std::vector<PixelCapture> captures =
        sort_captures(pixel_list_->read(count), lower_left, {1, 1}, true);
    leave_nothing_bound();
    check_gl("reading how fragments are lit");
    return captures.front().transmittance;
}

}  // namespace momentscope
