// moment_passes.hpp -- moment-based transparency: the paper's two geometry passes and its composite.
#pragma once
#include "core/gl/program.hpp"
#include "core/render/transparency.hpp"

namespace momentscope {

/// The shader variant that knows a moment-based technique.
ShaderVariant moment_variant(const Technique& technique);

/// The one that reconstructs with the parameters' solver, from moments or from factors.
ShaderVariant reconstruction_variant(const Technique& technique, const ResolvedParameters& parameters);

/// The one that adds up moments: by blending, or in order with an access that is not none.
ShaderVariant accumulation_variant(const Technique& technique, bool ordered, OrderedAccess access);

class MomentPasses : public Transparency {
public:
    /// Throws Error when the technique needs ordered access and there is none.
    MomentPasses(const Technique& technique, glm::ivec2 size, GLuint depth, OrderedAccess access);
    void draw_moments(const PassInput& input) override;
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input) override;
    std::optional<ShaderVariant> bind_for_capture(const ResolvedParameters& parameters) const override;
    bool draw_failures(const PassInput& input) override;

    std::vector<MomentVector> read_moments(glm::ivec2 corner, glm::ivec2 extent) const override;

private:
    void bind_stored() const;
    void draw_factors(const PassInput& input);
    void make_factors();

    const Technique& technique_;
    OrderedAccess access_;
    GlTexture total_absorbance_, moments_1_to_4_, moments_5_to_8_, weighted_color_;
    GlFramebuffer moment_target_, depth_target_, color_target_;
    std::vector<GlTexture> factors_;  // made when they are first needed
    GlFramebuffer factor_target_;
    glm::ivec2 size_;
    std::optional<float> factored_bias_;  // of what factors_ hold; nothing when moments are newer
};

}  // namespace momentscope
