// light.glsl -- the share of the light that reaches a point: the share that opaque casters let through times the share that
// transparent casters let through (paper, Section 6). core/shadow/shadow_filter.cpp and light_ray.cpp do the same in C++.
#include "passes/light_block.glsl"
#include "shared/light_place.glsl"

layout(binding = 12) uniform sampler2D opaque_map;             // filtered texels, or depths with UNFILTERED
#if defined(NO_TRANSPARENT_CASTERS)
#elif defined(DEEP_SHADOWS)
layout(binding = 13) uniform usampler2D deep_map;              // of each texel: index of its first step, number of steps
layout(binding = 14) uniform sampler2D deep_steps;             // depth, T behind it, in rows of 2048; ascending within a texel
#else
layout(binding = 13) uniform sampler2DArray transparent_map;   // filtered sums
#endif

#namespace opaque
#include "shared/portable_math.glsl"
#include "technique"
#endnamespace

#namespace transparent
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#ifdef PIXEL_STATE
#include "passes/caster_state.glsl"
#else
#include "passes/caster_moments.glsl"
#endif
#endnamespace

ShadowMapPosition light_place(vec3 eye_space)
{
    vec4 in_light = light.view_from_eye * vec4(eye_space, 1.0);
    return light_place_of(in_light, light.projection * in_light, light.range.xyz);
}

/// The four texels around a place and their bilinear weights, in the order (0, 0), (1, 0), (0, 1), (1, 1).
struct Corners { ivec2 texel[4]; float share[4]; };

Corners corners_at(vec2 at)
{
    vec2 below = floor(at - 0.5);
    vec2 part = at - 0.5 - below;
    ivec2 last = ivec2(int(light.range.z) - 1);
    Corners corners;
    for (int i = 0; i < 4; ++i)
    {
        ivec2 step = ivec2(i % 2, i / 2);
        corners.texel[i] = clamp(ivec2(below) + step, ivec2(0), last);
        corners.share[i] = (step.x == 1 ? part.x : 1.0 - part.x) * (step.y == 1 ? part.y : 1.0 - part.y);
    }
    return corners;
}

/// The weight of a texel at `offset` from the middle of the filter; 0 outside of the filter.
float filter_weight(int offset)
{
    int at = offset + light.radius.x;
    return at < 0 || at > 2 * light.radius.x ? 0.0 : light.weights[at / 4][at % 4];
}

/// The texels that the filter and the bilinear interpolation read together, for values that can be averaged only after the lookup.
/// Their offsets from `middle` go from -radius to radius + 1. At the border of the map, interpolation is clamped first and the
/// filter second, as with filtered maps.
struct Region { ivec2 middle; vec2 part; };

Region region_at(vec2 place)
{
    vec2 at = clamp(place, vec2(0.5), vec2(light.range.z - 0.5)) - 0.5;
    Region region;
    region.middle = ivec2(floor(at));
    region.part = at - floor(at);
    return region;
}

ivec2 region_texel(Region region, ivec2 offset)
{
    return clamp(region.middle + offset, ivec2(0), ivec2(int(light.range.z) - 1));
}

float region_weight(Region region, ivec2 offset)
{
    float across = mix(filter_weight(offset.x), filter_weight(offset.x - 1), region.part.x);
    float up = mix(filter_weight(offset.y), filter_weight(offset.y - 1), region.part.y);
    return across * up;
}

/// The share of the filter region whose opaque surface lies in front of the point.
float opaque_shadow(ShadowMapPosition place)
{
#ifdef opaque_UNFILTERED
    Region region = region_at(place.texel);
    float shadowed = 0.0;
    for (int y = -light.radius.x; y <= light.radius.x + 1; ++y)
        for (int x = -light.radius.x; x <= light.radius.x + 1; ++x)
        {
            float depth = texelFetch(opaque_map, region_texel(region, ivec2(x, y)), 0).x;
            shadowed += region_weight(region, ivec2(x, y))
                * opaque_shadowed_fraction(opaque_shadow_texel(depth), place.depth);
        }
    return shadowed;
#else
    Corners corners = corners_at(place.texel);
    vec4 mean = vec4(0.0);
    for (int i = 0; i < 4; ++i) mean += corners.share[i] * texelFetch(opaque_map, corners.texel[i], 0);
    return opaque_shadowed_fraction(opaque_make_shadow_texel(mean.x, mean.y, mean.z, mean.w), place.depth);
#endif
}

#ifdef DEEP_SHADOWS
vec2 deep_step(uint i)
{
    return texelFetch(deep_steps, ivec2(int(i & 2047u), int(i >> 11)), 0).xy;
}

/// T in front of a depth: that of the last step before it. Found by bisection.
float deep_transmittance(uvec2 list, float depth)
{
    uint in_front = 0u;
    uint end = list.y;
    while (in_front < end)
    {
        uint middle = (in_front + end) / 2u;
        if (deep_step(list.x + middle).x < depth) in_front = middle + 1u;
        else end = middle;
    }
    return in_front > 0u ? deep_step(list.x + in_front - 1u).y : 1.0;
}
#endif

/// The transmittance of the transparent casters in front of the point. own: the absorbance of the receiver itself.
float transparent_light(ShadowMapPosition place, float own)
{
#if defined(NO_TRANSPARENT_CASTERS)
    return 1.0;
#elif defined(DEEP_SHADOWS)
    Region region = region_at(place.texel);
    float lit = 0.0;
    for (int y = -light.radius.x; y <= light.radius.x + 1; ++y)
        for (int x = -light.radius.x; x <= light.radius.x + 1; ++x)
        {
            uvec2 list = texelFetch(deep_map, region_texel(region, ivec2(x, y)), 0).xy;
            lit += region_weight(region, ivec2(x, y)) * deep_transmittance(list, place.depth);
        }
    return lit;
#else
    Corners corners = corners_at(place.texel);
    transparent_CasterSums sums;
    for (int layer = 0; layer < CASTER_LAYERS; ++layer)
    {
        vec4 mean = vec4(0.0);
        for (int i = 0; i < 4; ++i)
            mean += corners.share[i] * texelFetch(transparent_map, ivec3(corners.texel[i], layer), 0);
        for (int i = 0; i < 4; ++i) sums.f[4 * layer + i] = mean[i];
    }
    for (int i = 4 * CASTER_LAYERS; i < 16; ++i) sums.f[i] = 0.0;
    return transparent_caster_transmittance(sums, place.depth, own, light.reconstruction);
#endif
}

/// The share of the light that reaches a point in eye space; 1 outside of the map. own: as in transparent_light.
float light_visibility(vec3 eye_space, float own)
{
    ShadowMapPosition place = light_place(eye_space);
    if (!place.within) return 1.0;
    return (1.0 - opaque_shadow(place)) * transparent_light(place, own);
}
