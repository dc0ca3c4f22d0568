#include "core/render/peeling_passes.hpp"

#include <fmt/format.h>

#include "core/gl/texture.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

// Ends the loop on a GL that stores depth with fewer digits than it compares. There the same layer would come
// again for ever.
constexpr int MAX_LAYERS = 4096;

}  // namespace

PeelingPasses::PeelingPasses(glm::ivec2 size, GLuint /*depth: copied for every layer*/)
    : layer_(make_texture(GL_RGBA32F, size)),
      sum_(make_texture(GL_RGBA32F, size)),
      sum_target_(make_framebuffer({sum_}, 0)) {
    for (int i = 0; i < 2; ++i) {
        depths_[i] = make_texture(GL_DEPTH_COMPONENT32F, size);
        layer_targets_[i] = make_framebuffer({layer_}, depths_[i]);
    }
    GLuint name = 0;
    glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &name);
    any_fragment_ = GlQuery(name);
}

bool PeelingPasses::draw_layer(const PassInput& input, int layer) {
    const int now = layer % 2;
    const float zero[4] = {0, 0, 0, 0};
    if (layer == 0)
        glClearNamedFramebufferfv(layer_targets_[1], GL_DEPTH, 0, zero);  // nothing lies before the first
    glCopyImageSubData(input.depth, GL_TEXTURE_2D, 0, 0, 0, 0, depths_[now], GL_TEXTURE_2D, 0, 0, 0, 0,
                       input.size.x, input.size.y, 1);
    glClearNamedFramebufferfv(layer_targets_[now], GL_COLOR, 0, zero);
    glBindFramebuffer(GL_FRAMEBUFFER, layer_targets_[now]);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(input.programs.get("passes/scene.vert", "passes/peel.frag", input.lit({})));
    glBindTextureUnit(0, depths_[1 - now]);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, any_fragment_);
    input.scene.draw(Surfaces::transparent);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glDisable(GL_DEPTH_TEST);
    GLuint any = 0;
    glGetQueryObjectuiv(any_fragment_, GL_QUERY_RESULT, &any);
    return any != 0;
}

// sum += T layer and T *= 1 - opacity, where T is the alpha channel of the target.
void PeelingPasses::add_layer(const PassInput& input) {
    glBindFramebuffer(GL_FRAMEBUFFER, sum_target_);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(input.programs.get("passes/fullscreen.vert", "passes/copy.frag"));
    glBindTextureUnit(0, layer_);
    draw_fullscreen();
    glDisable(GL_BLEND);
}

void PeelingPasses::draw_color(const PassInput& input) {
    const float nothing[4] = {0, 0, 0, 1};
    glClearNamedFramebufferfv(sum_target_, GL_COLOR, 0, nothing);
    for (int layer = 0; draw_layer(input, layer); ++layer) {
        if (layer == MAX_LAYERS)
            throw Error(fmt::format(
                "The picture has more than {} layers of transparent surfaces; use sorted.", MAX_LAYERS));
        add_layer(input);
    }
}

void PeelingPasses::draw_composite(const PassInput& input) {
    glUseProgram(input.programs.get("passes/fullscreen.vert", "passes/peel_composite.frag"));
    glBindTextureUnit(0, input.opaque_color);
    glBindTextureUnit(1, sum_);
    draw_fullscreen();
}

}  // namespace momentscope
