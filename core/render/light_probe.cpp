#include "core/render/light_probe.hpp"

#include <cassert>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

LightProbe::LightProbe(const DrawnPicture& picture, GLuint depth) : size_(picture.view.size) {
    assert(picture.shadows != nullptr && "the picture has no shadows");
    probe_ = make_texture(GL_RGBA32F, size_);
    target_ = make_framebuffer({probe_}, depth);
    clear_color(target_, 0, glm::vec4(0, 1, 2, 0));
    picture.bind();
    use_program(
        picture.input.programs.get("passes/scene.vert", "passes/light_probe.frag", picture.input.lit({})));
    set_draw_state({.depth = DepthTest::equal, .writes_depth = false});
    bind_framebuffer(target_);
    picture.input.scene.draw(Surfaces::opaque);
    leave_nothing_bound();
}

std::optional<LitSurface> LightProbe::surface(glm::ivec2 pixel) const {
    const glm::vec4 probe = read_colors(probe_, {{pixel.x, size_.y - 1 - pixel.y}, {1, 1}}).front();
    check_gl("reading how a surface is lit");
    if (!(probe.w > 0)) return std::nullopt;
    return LitSurface{probe.w, probe.x, probe.y};
}

}  // namespace momentscope
