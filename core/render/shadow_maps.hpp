// shadow_maps.hpp -- the light's maps of opaque and of transparent casters, drawn and filtered.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/gl/program.hpp"
#include "core/render/fragment_list.hpp"
#include "core/render/pass_timing.hpp"
#include "core/render/shader_lighting.hpp"
#include "core/shadow/light_camera.hpp"
#include "core/shadow/light_ray.hpp"

namespace momentscope {

/// How often a stage ran, and how long it took when it last did.
struct ShadowStage {
    double milliseconds = 0;
    int runs = 0;
};

struct ShadowStages {
    ShadowStage opaque_render, opaque_filter, transparent_render, transparent_filter;
};

class ShadowMaps {
public:
    ShadowMaps(PassTiming timing, std::shared_ptr<ProgramCache> programs);

    /// Draws and filters what the change since the last call made stale: the light's place and the size both
    /// maps, a technique its own, the radius their filtering, beta and alpha nothing. Scene and casters are
    /// the same in every call. Throws Error when the light stands among the casters or the maps are too large
    /// for this GL.
    void update(const SceneBuffers& scene, const Sphere& casters, const ShadowSettings& settings);

    /// Binds what passes/light.glsl reads. eye_view: world to eye.
    void bind(const glm::mat4& eye_view) const;

    const ShaderLighting& lighting() const { return lighting_; }
    const ShadowStages& stages() const { return stages_; }
    const LightCamera& frame() const { return frame_; }
    const ShadowSettings& settings() const { return *settings_; }

    /// What the filter region of a place is made of, and what the map holds of it.
    ShadowFilterSamples capture(const SceneBuffers& scene, const ShadowMapPosition& place);

private:
    struct DeepMap {
        GlTexture lists;  // first step and how many, per texel
        GlBuffer steps;   // depth and T behind it
    };

    void make_depths();
    void make_opaque();
    void make_sums();
    void draw_opaque(const SceneBuffers& scene);
    void draw_sums(const SceneBuffers& scene);
    void draw_deep(const SceneBuffers& scene);
    void filter_opaque();
    void filter_sums();
    void write_blocks(const glm::mat4& eye_view) const;
    std::optional<std::vector<FragmentNode>> capture_texels(const SceneBuffers& scene, glm::ivec2 corner,
                                                            glm::ivec2 extent);
    void capture_region(const SceneBuffers& scene, ShadowFilterSamples& bundle);
    void read_filtered(ShadowFilterSamples& bundle) const;

    template <typename Draw>
    void run(ShadowStage& stage, const Draw& draw);

    PassTiming timing_;
    GlQuery timer_;
    GlBuffer frame_block_, light_block_;
    std::optional<ShadowSettings> settings_;  // of what the maps hold
    LightCamera frame_;
    ShaderLighting lighting_;
    ShadowStages stages_;
    std::shared_ptr<ProgramCache> programs_;

    GlTexture nearest_, nearest_depth_;           // depths of opaque casters, and what tests them
    GlTexture opaque_filtered_, opaque_halfway_;  // halfway: filtered in one direction
    GlTexture sums_, filtered_, halfway_;         // of transparent casters, in layers of four numbers
    GlTexture no_depth_;                          // all at the far end
    GlFramebuffer nearest_target_, opaque_target_, opaque_halfway_target_, sums_target_, halfway_target_;
    std::vector<GlFramebuffer> filtered_targets_;  // of each layer
    std::unique_ptr<FragmentList> list_;
    DeepMap deep_;
};

}  // namespace momentscope
