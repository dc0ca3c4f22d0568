// pixel_ends.glsl -- the ends of the ray of a pixel as a texel of two 16-bit numbers, and the depth that its moments are taken of.
#include "shared/ends.glsl"

#ifdef KNOWN_ENDS
layout(binding = 9) uniform sampler2D ends_texture;

Ends ends_of_texel(vec2 texel)
{
    PRECISE vec2 steps = floor(texel * END_STEPS + 0.5);
    return make_ends(steps.x, steps.y);
}

Ends stored_ends(ivec2 pixel)
{
    return ends_of_texel(texelFetch(ends_texture, pixel, 0).xy);
}
#else
Ends stored_ends(ivec2 pixel)
{
    return make_ends(0.0, 0.0);
}
#endif

vec4 ends_texel(Ends ends)
{
    return vec4(ends.near / END_STEPS, ends.far / END_STEPS, 0.0, 0.0);
}

#ifdef OWN_INTERVAL
const bool IN_OWN_INTERVAL = true;
#else
const bool IN_OWN_INTERVAL = false;
#endif

/// The depth of a fragment in the interval that moments are taken of.
float moment_depth(float depth, Ends ends)
{
#ifdef OWN_INTERVAL
    return depth_in_interval(depth, ends);
#else
    return depth;
#endif
}
