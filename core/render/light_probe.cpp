#include "core/render/light_probe.hpp"

#include <cassert>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

LightProbe::LightProbe(const DrawnPicture& picture, GLuint depth) : size_(picture.view.size) {
    assert(picture.shadows != nullptr && "the picture has no shadows");
    probe_ = make_texture(GL_RGBA32F, size_);
    target_ = make_framebuffer({probe_}, depth);
    const float nothing[4] = {0, 1, 2, 0};
    glClearNamedFramebufferfv(target_, GL_COLOR, 0, nothing);
    picture.bind();
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glUseProgram(
        picture.input.programs.get("passes/scene.vert", "passes/light_probe.frag", picture.input.lit({})));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    picture.input.scene.draw(Surfaces::opaque);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    leave_nothing_bound();
}

std::optional<LitSurface> LightProbe::surface(glm::ivec2 pixel) const {
    glm::vec4 probe;
    glGetTextureSubImage(probe_, 0, pixel.x, size_.y - 1 - pixel.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                         sizeof(probe), &probe);
    check_gl("reading how a surface is lit");
    if (!(probe.w > 0)) return std::nullopt;
    return LitSurface{probe.w, probe.x, probe.y};
}

}  // namespace momentscope
