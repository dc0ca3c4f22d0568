// shadow_texel.glsl -- what a texel of an opaque shadow map stores. A math file says with
//   shadow_texel       what it stores for the depth of the nearest surface
//   shadowed_fraction  the share of a filter region that lies in front of a receiver, from the mean of its texels
// and with UNFILTERED that texels must not be mixed, but their answers may.

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
