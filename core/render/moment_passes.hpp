// moment_passes.hpp -- moment-based transparency: the two geometry passes and the composite of the paper.
#pragma once
#include "core/gl/program.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

/// The shader variant of a technique with moments.
ShaderVariant moment_variant(const Technique& technique);

/// The variant that reconstructs, with the solver of the parameters, from moments or from factors.
ShaderVariant reconstruction_variant(const Technique& technique, const ResolvedParameters& parameters);

/// The variant that factors the moments of a pixel.
ShaderVariant factor_variant(const Technique& technique, const ResolvedParameters& parameters);

/// The variant that sums moments: by blending, or in order. With known ends it also keeps them, if this GL
/// can in the same pass.
ShaderVariant accumulation_variant(const Technique& technique, const ResolvedParameters& parameters,
                                   const Capabilities& gl);

class MomentPasses : public Transparency {
public:
    /// Throws Error if the GL lacks what the technique needs.
    MomentPasses(const Technique& technique, glm::ivec2 size, GLuint depth, const Capabilities& gl);
    void draw_moments(const PassInput& input) override;
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input, GLuint target) override;
    std::optional<ShaderVariant> bind_for_capture(const ResolvedParameters& parameters) const override;
    bool draw_diagnosis(const PassInput& input, Diagnosis diagnosis, GLuint target) override;

    std::vector<MomentVector> read_moments(const TexelRect& rect) const override;

private:
    void bind_stored() const;
    void make_optional_targets(const ResolvedParameters& parameters);
    void draw_ends(const PassInput& input);
    void draw_factors(const PassInput& input);
    void make_factors(int floats);
    GLenum ends_format() const;

    const Technique& technique_;
    Capabilities gl_;
    GlTexture total_absorbance_, moments_1_to_4_, moments_5_to_8_, weighted_color_;
    GlTexture ends_, uncertain_color_;  // made at first use
    GlFramebuffer moment_target_, depth_target_, color_target_;
    GlFramebuffer moments_and_ends_target_, ends_target_, uncertain_target_;
    GLuint depth_;
    bool has_ends_ = false;                      // did the first pass store the ends?
    std::vector<GlTexture> factors_;             // made at first use
    int factor_floats_ = 0;                      // numbers of a pixel in factors_
    std::vector<GlFramebuffer> factor_targets_;  // several if a pass cannot draw to all of them at once
    glm::ivec2 size_;
    std::optional<float> factored_bias_;  // alpha of factors_; nullopt if the moments are newer
};

}  // namespace momentscope
