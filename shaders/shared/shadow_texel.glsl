// shadow_texel.glsl -- what a texel of a shadow map of opaque casters stores. A math file defines two functions:
//   shadow_texel       what the texel stores for the depth of the nearest surface
//   shadowed_fraction  the share of a filter region that lies in front of a receiver, from the mean of the texels of the region
// If it defines UNFILTERED, texels must not be averaged; their shadowed fractions are averaged instead.

struct ShadowTexel { float f[4]; };

FN ShadowTexel make_shadow_texel(float a, float b, float c, float d)
{
    ShadowTexel texel;
    texel.f[0] = a;
    texel.f[1] = b;
    texel.f[2] = c;
    texel.f[3] = d;
    return texel;
}
