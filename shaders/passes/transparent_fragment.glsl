// transparent_fragment.glsl -- opacity, depth and random seed of the current fragment, for all transparent passes.
#define TRANSPARENT_FRAGMENT
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "shared/random_bits.glsl"
#include "shared/alpha_threshold.glsl"

INVARIANT_IN vec3 object_position;

INVARIANT_IN vec2 texture_coordinate;

#ifndef NO_ALPHA_MAPS
layout(binding = 15) uniform sampler2D alpha_map;   // white if the object has none
#endif

/// The opacity of the current fragment; it may be 0. The map is always sampled at level 0. A sample must not depend on derivatives,
/// because passes compute them for different pixels.
float fragment_opacity()
{
#ifdef NO_ALPHA_MAPS   // the scene has no alpha maps; this saves a fetch
    return object.color_opacity.a;
#else
    return object.color_opacity.a * textureLod(alpha_map, texture_coordinate, 0.0).x;
#endif
}

float fragment_absorbance()
{
#ifdef NO_ALPHA_MAPS   // the absorbance of the object; this saves a logarithm
    return object.absorbance.x;
#else
    return absorbance_of_opacity(fragment_opacity());
#endif
}

#ifdef SHADOWS
float receiver_absorbance()
{
    return fragment_absorbance();
}
#endif

float fragment_view_depth()
{
    return -eye_position.z;
}

uint fragment_pixel()
{
    return uint(gl_FragCoord.x) + 65536u * uint(gl_FragCoord.y);
}

uint fragment_random_seed()
{
    return fragment_seed(fragment_pixel(), object.draw.y, floatBitsToUint(fragment_view_depth()));
}

/// The threshold of hashed alpha testing. Takes derivatives, so call it where all lanes of a quad are active.
float fragment_threshold()
{
    PRECISE float width = max(length(dFdx(object_position)), length(dFdy(object_position)));
    return alpha_threshold(object_position.x, object_position.y, object_position.z, width);
}

float fragment_depth()
{
    DepthWarpFactors warp;
    warp.origin = frame.depth_warp.x;
    warp.scale = frame.depth_warp.y;
    warp.linear = frame.picture.z > 0;
    return warped_depth(fragment_view_depth(), warp);
}
