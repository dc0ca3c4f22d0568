// transparent_fragment.glsl -- opacity and depth of the fragment at hand, for all transparent passes.
#define TRANSPARENT_FRAGMENT
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"

float fragment_opacity()
{
    return object.color_opacity.a;
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
