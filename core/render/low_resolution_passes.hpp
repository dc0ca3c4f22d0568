// low_resolution_passes.hpp -- builds states at the resolution of the picture or a lower one, twice if there
// are two sets of moments, and converts them before they are read (Sharpe 2018, Section 4).
#pragma once
#include "core/render/state_passes.hpp"

namespace momentscope {

class LowResolutionPasses : public StatePasses {
public:
    LowResolutionPasses(const Technique& technique, glm::ivec2 size, GLuint depth, const Capabilities& gl);
    void draw_moments(const PassInput& input) override;
    std::optional<LowTarget> low_target() const override;

private:
    void bind_states() const override;
    void make_targets(int divisor);
    void draw_low_depth(const PassInput& input);
    void draw_set(const PassInput& input, bool second);
    void convert(const PassInput& input);

    GLuint full_depth_;
    glm::ivec2 low_size_{0};
    GlTexture low_depth_;  // none at the resolution of the picture
    std::vector<GlTexture> sums_, converted_;
    GlFramebuffer depth_target_, first_target_, second_target_, converted_target_;
};

}  // namespace momentscope
