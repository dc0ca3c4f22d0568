// moment_texels.glsl -- the moments of a pixel as two texels of four moments each.

Moments moments_of_texels(float b0, vec4 first, vec4 second)
{
    Moments moments;
    moments.b0 = b0;
    moments.b[0] = first.x;
    moments.b[1] = first.y;
    moments.b[2] = first.z;
    moments.b[3] = first.w;
#if MOMENT_FLOATS > 4
    moments.b[4] = second.x;
    moments.b[5] = second.y;
#endif
#if MOMENT_FLOATS > 6
    moments.b[6] = second.z;
    moments.b[7] = second.w;
#endif
    return moments;
}
