// light_place.glsl -- the place of a point in the map of the light.

/// texel: the place in texels, from the lower left corner of the map. depth: in [-1, 1], clamped to the depth range. within: true
/// if the map knows what shadows the point.
struct ShadowMapPosition { vec2 texel; float depth; bool within; };

/// in_light: the point in the space of the light, which looks along -z. clip: the projection of this point. range: origin and scale
/// of the linear depth (fragment.glsl), and the number of texels along a side of the map. Points nearer than the origin are not
/// within.
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
