// factor_texels.glsl -- the factor of a pixel as up to three texels of four numbers.

vec4 factor_texel(StoredFactor stored, int texel)
{
    vec4 result = vec4(0.0);
    UNROLL
    for (int i = 0; i < 4; ++i)
        if (4 * texel + i < FACTOR_FLOATS) result[i] = stored.x[min(4 * texel + i, FACTOR_FLOATS - 1)];
    return result;
}

StoredFactor factor_of_texels(vec4 texels[3])
{
    StoredFactor stored;
    UNROLL
    for (int i = 0; i < FACTOR_FLOATS; ++i) stored.x[i] = texels[i / 4][i % 4];
    return stored;
}
