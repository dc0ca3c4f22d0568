// peeling_passes.hpp -- a second ground truth: depth peeling (Everitt 2001). It is also what `sorted` draws
// on a GL whose shaders cannot write lists.
#pragma once
#include "core/gl/program.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

/// What becomes of fragments that have one depth in the depth buffer: only the first that was submitted is
/// drawn, as published; or all are drawn, the later on top, which takes a second geometry pass.
enum class Ties { lost, kept };

class PeelingPasses : public Transparency {
public:
    PeelingPasses(glm::ivec2 size, GLuint depth, Ties ties, const Capabilities& gl);
    void draw_moments(const PassInput&) override {}

    /// Peels one layer after another until one is empty everywhere. Each layer lies strictly behind the
    /// previous one, so there are at most as many as a pixel has fragments. Where queries have no answer
    /// within a frame, that many are drawn.
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input, GLuint target) override;

private:
    int most_fragments(const PassInput& input);          // in front of opaque surfaces, of any pixel
    bool draw_layer(const PassInput& input, int layer);  // false if the layer is known to be empty
    void draw_ties(const PassInput& input, GLuint target);
    void add_layer(const PassInput& input);

    Ties ties_;
    bool answers_at_once_;
    GlTexture depths_[2];  // of this layer and of the previous one, in turn
    GlTexture layer_, sum_;
    GlFramebuffer depth_targets_[2], layer_targets_[2], sum_target_, opaque_depth_, count_target_;
    GLuint opaque_texture_;
    GlQuery any_fragment_;
};

}  // namespace momentscope
