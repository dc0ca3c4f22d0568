// peeling_passes.hpp -- a second ground truth: depth peeling (Everitt 2001).
#pragma once
#include "core/gl/program.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

class PeelingPasses : public Transparency {
public:
    PeelingPasses(glm::ivec2 size, GLuint depth);
    void draw_moments(const PassInput&) override {}

    /// Peels one layer after another until one is empty everywhere. Each layer lies strictly behind the
    /// previous one, so there are at most as many as a pixel has fragments.
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input, GLuint target) override;

private:
    bool draw_layer(const PassInput& input, int layer);  // false if the layer is empty
    void add_layer(const PassInput& input);

    GlTexture depths_[2];  // of this layer and of the previous one, in turn
    GlTexture layer_, sum_;
    GlFramebuffer layer_targets_[2], sum_target_, opaque_depth_;
    GlQuery any_fragment_;
};

}  // namespace momentscope
