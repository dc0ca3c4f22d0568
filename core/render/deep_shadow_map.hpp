// deep_shadow_map.hpp -- the map of the light with all fragments of every texel: the ground truth of shadows.
#pragma once
#include "core/render/caster_texels.hpp"

namespace momentscope {

constexpr int DEEP_ROW = 2048;  // light.glsl

struct DeepShadowMap {
    GlTexture lists;  // of each texel: index of its first step, number of steps
    GlTexture steps;  // depth and T behind it, in rows of DEEP_ROW
};

/// The map of size x size texels. The CPU sorts the fragments; this is a ground truth and not fast. Throws
/// Error if this GL cannot hold it.
DeepShadowMap make_deep_shadow_map(CasterTexels& texels, const SceneBuffers& scene, GLuint frame_block,
                                   int size);

}  // namespace momentscope
