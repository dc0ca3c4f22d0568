// transparent_fragment.glsl -- opacity and depth of the fragment at hand, for all transparent passes.
#define TRANSPARENT_FRAGMENT
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"

in vec2 texture_coordinate;

layout(binding = 15) uniform sampler2D alpha_map;   // white where the object has none

/// May be 0. Level 0 always: what a pass samples must not depend on derivatives, which passes compute for different
/// pixels.
float fragment_opacity()
{
    return object.color_opacity.a * textureLod(alpha_map, texture_coordinate, 0.0).x;
}

float fragment_view_depth()
{
    return -eye_position.z;
}

float fragment_depth()
{
    DepthWarpFactors warp;
    warp.log_z_min = frame.depth_warp.x;
    warp.scale = frame.depth_warp.y;
    return warped_depth(fragment_view_depth(), warp);
}
