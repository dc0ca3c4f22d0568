// shadow_capture.hpp -- captures what lies in the filter region of a receiver of light.
#pragma once
#include "core/render/caster_texels.hpp"
#include "core/shadow/light_camera.hpp"
#include "core/shadow/light_ray.hpp"

namespace momentscope {

/// The maps of the light as textures.
struct ShadowMapTextures {
    GLuint nearest;          // depths of opaque casters
    GLuint opaque_filtered;  // 0: this kind of map is not filtered
    GLuint filtered;         // sums of transparent casters, in layers of four numbers
    std::size_t layers;
};

/// The fragments and depths in the filter region of a place, and what the filtered maps hold there. Throws
/// Error if there are too many fragments.
ShadowFilterSamples capture_filter_region(CasterTexels& texels, const SceneBuffers& scene, GLuint frame_block,
                                          const ShadowMapTextures& maps, const LightCamera& frame,
                                          const ShadowSettings& settings, const ShadowMapPosition& place);

}  // namespace momentscope
