#include "core/render/peeling_passes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/query.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

// Ends the loop on a GL that stores depth with fewer digits than it compares. There the same layer would come
// again for ever.
constexpr int MAX_LAYERS = 4096;

}  // namespace

PeelingPasses::PeelingPasses(glm::ivec2 size, GLuint depth, Ties ties, const Capabilities& gl)
    : ties_(ties),
      answers_at_once_(gl.answers_at_once),
      layer_(make_texture(GL_RGBA32F, size)),
      sum_(make_texture(GL_RGBA32F, size)),
      sum_target_(make_framebuffer({sum_}, 0)),
      opaque_depth_(make_framebuffer({}, depth)),
      count_target_(make_framebuffer({layer_}, depth)),
      opaque_texture_(depth),
      any_fragment_(make_query()) {
    for (int i = 0; i < 2; ++i) {
        depths_[i] = make_texture(GL_DEPTH_COMPONENT32F, size);
        depth_targets_[i] = make_framebuffer({}, depths_[i]);
        layer_targets_[i] = make_framebuffer({layer_}, depths_[i]);
    }
}

int PeelingPasses::most_fragments(const PassInput& input) {
    clear_color(count_target_, 0, glm::vec4(0));
    set_draw_state({.depth = DepthTest::nearer, .writes_depth = false, .blending = Blending::add});
    bind_framebuffer(count_target_);
    use_program(input.programs.get("passes/scene.vert", "passes/count.frag"));
    input.scene.draw(Surfaces::transparent);
    float most = 0;
    for (const glm::vec4& texel : read_colors(layer_, {{0, 0}, input.size})) most = std::max(most, texel.r);
    return static_cast<int>(most);
}

bool PeelingPasses::draw_layer(const PassInput& input, int layer) {
    const int now = layer % 2;
    if (layer == 0) clear_depth(depth_targets_[1], 0);  // nothing lies before the first
    copy_depth(opaque_depth_, depth_targets_[now], input.size);
    clear_color(layer_targets_[now], 0, glm::vec4(0));
    set_draw_state({.depth = DepthTest::nearer});
    const bool keep = ties_ == Ties::kept;
    bind_framebuffer(keep ? depth_targets_[now] : layer_targets_[now]);
    use_program(keep ? input.programs.get("passes/scene.vert", "passes/peel_depth.frag")
                     : input.programs.get("passes/scene.vert", "passes/peel.frag", input.lit({})));
    bind_texture(0, depths_[1 - now]);
    if (answers_at_once_) begin_any_fragment(any_fragment_);
    input.scene.draw(Surfaces::transparent);
    if (answers_at_once_) {
        end_any_fragment();
        if (!any_fragment(any_fragment_)) return false;
    }
    if (keep) draw_ties(input, layer_targets_[now]);
    return true;
}

// The opaque depth, which stays where a pixel has no layer, is also equal to that of fragments in an opaque
// surface; the shader drops these.
void PeelingPasses::draw_ties(const PassInput& input, GLuint target) {
    set_draw_state({.depth = DepthTest::equal, .writes_depth = false, .blending = Blending::over});
    bind_framebuffer(target);
    use_program(input.programs.get("passes/scene.vert", "passes/peel_ties.frag", input.lit({})));
    bind_texture(0, opaque_texture_);
    input.scene.draw(Surfaces::transparent);
}

// sum += T layer and T *= 1 - opacity, where T is the alpha channel of the target.
void PeelingPasses::add_layer(const PassInput& input) {
    set_draw_state({.blending = Blending::under});
    bind_framebuffer(sum_target_);
    use_program(input.programs.get("passes/fullscreen.vert", "passes/copy.frag"));
    bind_texture(0, layer_);
    draw_fullscreen();
}

void PeelingPasses::draw_color(const PassInput& input) {
    const int enough = answers_at_once_ ? MAX_LAYERS + 1 : most_fragments(input);
    clear_color(sum_target_, 0, glm::vec4(0, 0, 0, 1));
    for (int layer = 0; layer < enough && draw_layer(input, layer); ++layer) {
        if (layer == MAX_LAYERS)
            throw Error(fmt::format("The picture has more than {} layers of transparent surfaces; {}.",
                                    MAX_LAYERS, ties_ == Ties::lost ? "use sorted" : "simplify the scene"));
        add_layer(input);
    }
}

void PeelingPasses::draw_composite(const PassInput& input, GLuint target) {
    set_draw_state({});
    bind_framebuffer(target);
    use_program(input.programs.get("passes/fullscreen.vert", "passes/peel_composite.frag"));
    bind_texture(0, input.opaque_color);
    bind_texture(1, sum_);
    draw_fullscreen();
}

}  // namespace momentscope
