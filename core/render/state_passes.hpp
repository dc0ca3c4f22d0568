// state_passes.hpp -- techniques without moments. One geometry pass builds the state of each pixel by
// blending, by atomic operations or in order. The state either holds the colour already, or weighs it in a
// second pass.
#pragma once
#include "core/render/transparency.hpp"

namespace momentscope {

/// The shader variant of a technique with these settings, which reads its states.
ShaderVariant state_variant(const Technique& technique, const ParameterValues& settings);

/// The variant that builds states. access: none if blending is enough.
ShaderVariant state_building_variant(const Technique& technique, const ParameterValues& settings,
                                     OrderedAccess access);

/// The number of groups of four numbers that a pixel stores.
int texel_count(const Technique& technique, const ParameterValues& settings);

class StatePasses : public Transparency {
public:
    /// Throws Error if the GL lacks what the technique needs.
    StatePasses(const Technique& technique, glm::ivec2 size, GLuint depth, const Capabilities& gl);
    void draw_moments(const PassInput& input) override;
    void draw_color(const PassInput& input) override;
    void draw_composite(const PassInput& input, GLuint target) override;
    std::optional<ShaderVariant> bind_for_capture(const ResolvedParameters& parameters) const override;

protected:
    static constexpr unsigned FIRST_STATE_UNIT = 2;  // texture unit, as in passes/stored_state.glsl

    virtual void bind_states() const;

    const Technique& technique_;
    glm::ivec2 size_;
    ParameterValues settings_;

private:
    void make_states(const ParameterValues& settings);
    void make_samples(int count);
    void clear_states() const;
    void draw_states(const PassInput& input, GLuint target) const;

    GLuint depth_;
    int most_targets_;
    OrderedAccess access_;                       // none if blending is enough
    std::vector<GlTexture> states_;              // of four floats each
    GlTexture samples_;                          // depths as bits, one layer per sample
    std::vector<GlFramebuffer> sample_targets_;  // to clear its layers
    int sample_count_ = 0;
    GlTexture nearest_depth_;                   // for techniques that keep the nearest fragment
    std::vector<GlFramebuffer> state_targets_;  // several if a pass cannot draw to all states at once
    GlFramebuffer depth_target_;
    GlTexture weighted_color_, exact_absorbance_;
    GlFramebuffer color_target_;
};

}  // namespace momentscope
