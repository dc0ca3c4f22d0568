// light_place.glsl -- where the light's map has a point.

/// Texel: place in texels from the map's lower left. depth: in [-1, 1] of the depth range, beyond it cut. within: does the map
/// know what shadows the point?
struct ShadowMapPosition { vec2 texel; float depth; bool within; };

/// in_light: the point in the light's space, which looks along -z; clip: projected. range: origin and scale of the linear depth
/// (fragment.glsl), texels of a side of the map. Nothing nearer than the origin is within.
FN ShadowMapPosition light_place_of(IN(vec4) in_light, IN(vec4) clip, IN(vec3) range)
{
    ShadowMapPosition place;
    float size = range.z;
    place.texel = vec2((clip.x / clip.w * 0.5f + 0.5f) * size, (clip.y / clip.w * 0.5f + 0.5f) * size);
    place.depth = clamp((-in_light.z - range.x) * range.y - 1.0f, -1.0f, 1.0f);
    place.within = -in_light.z > range.x && min(place.texel.x, place.texel.y) >= 0.0f
        && max(place.texel.x, place.texel.y) <= size;
    return place;
}
