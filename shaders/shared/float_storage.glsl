// float_storage.glsl -- moments stored in 32-bit floats. They are summed as additive blending does it.

/// What a pixel stores after one more fragment. stored: what it stored before. fragment: result of fragment_moments.
FN Moments with_fragment(IN(Moments) stored, IN(Moments) fragment)
{
    Moments sum;
    sum.b0 = stored.b0 + fragment.b0;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i) sum.b[i] = stored.b[i] + fragment.b[i];
    return sum;
}

/// The moments that the stored numbers represent.
FN Moments unpacked_moments(IN(Moments) stored)
{
    return stored;
}
