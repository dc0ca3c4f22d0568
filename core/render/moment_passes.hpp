// moment_passes.hpp -- moment-based transparency: the paper's two additive passes and its composite.
#pragma once
#include "core/gl/program.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

/// The shader variant that computes a moment-based technique.
ShaderVariant moment_variant(const Technique& technique);

class MomentPasses : public Transparency {
public:
    MomentPasses(const Technique& technique, glm::ivec2 size, GLuint depth);
    void draw_moments(const PassInput& input) override;
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input) override;
    bool bind_for_capture() const override;
    bool draw_failures(const PassInput& input) override;

private:
    void bind_moments() const;

    GlTexture total_absorbance_, moments_1_to_4_, moments_5_to_8_, weighted_color_;
    GlFramebuffer moment_target_, color_target_;
    GlProgram moment_program_, color_program_, composite_program_;
    GlProgram failure_program_;  // linked when it is first asked for
    const Technique& technique_;
};

}  // namespace momentscope
