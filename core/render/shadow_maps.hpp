// shadow_maps.hpp -- draws and filters the maps of the light, one of opaque and one of transparent casters.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/gl/pass_timing.hpp"
#include "core/gl/program.hpp"
#include "core/render/deep_shadow_map.hpp"
#include "core/render/shader_lighting.hpp"
#include "core/render/shadow_capture.hpp"

namespace momentscope {

/// How often a stage has run, and how long it took when it last ran.
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

    /// Draws and filters what is stale after the change since the last call. The place of the light and the
    /// size make both maps stale, the kind of a map makes this map stale, the radius makes the filtering
    /// stale, and beta and alpha make nothing stale. Scene and casters must be the same in every call. Throws
    /// Error if the light stands among the casters, or if the maps are too large for this GL.
    void update(const SceneBuffers& scene, const Sphere& casters, const ShadowSettings& settings);

    /// Binds what passes/light.glsl reads. eye_view: the transform from the world to the eye.
    void bind(const glm::mat4& eye_view) const;

    const ShaderLighting& lighting() const { return lighting_; }
    const ShadowStages& stages() const { return stages_; }
    const LightCamera& frame() const { return frame_; }
    const ShadowSettings& settings() const { return *settings_; }

    /// The fragments and depths in the filter region of a place, and what the filtered maps hold there.
    ShadowFilterSamples capture(const SceneBuffers& scene, const ShadowMapPosition& place);

private:
    void make_depths();
    void make_opaque();
    void make_sums();
    void draw_opaque(const SceneBuffers& scene);
    void draw_sums(const SceneBuffers& scene);
    void filter_opaque();
    void filter_sums();
    void write_blocks(const glm::mat4& eye_view) const;
    template <typename Draw>
    void run(ShadowStage& stage, const Draw& draw);

    PassTiming timing_;
    GlQuery timer_;
    GlBuffer frame_block_, light_block_;
    std::optional<ShadowSettings> settings_;  // of the current maps
    LightCamera frame_;
    ShaderLighting lighting_;
    ShadowStages stages_;
    std::shared_ptr<ProgramCache> programs_;

    GlTexture nearest_, nearest_depth_;           // depths of opaque casters; their depth buffer
    GlTexture opaque_filtered_, opaque_halfway_;  // halfway: filtered in one direction only
    GlTexture sums_, filtered_, halfway_;         // of transparent casters, in layers of four numbers
    GlFramebuffer nearest_target_, opaque_target_, opaque_halfway_target_, sums_target_, halfway_target_;
    std::vector<GlFramebuffer> filtered_targets_;  // one per layer
    std::unique_ptr<CasterTexels> texels_;
    DeepShadowMap deep_;
};

}  // namespace momentscope
