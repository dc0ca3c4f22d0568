// rounding.glsl -- numbers as textures of few bits hold them. Rounding is done here and not by the texture unit, which then
// writes what it can hold exactly: the same bits everywhere.

/// x in [0, 1] as the nearest multiple of 1/65535. What a texture unit makes of such a number comes out as it was.
FN float rounded_to_unorm16(float x)
{
    PRECISE float code = floor(clamp(x, 0.0f, 1.0f) * 65535.0f + 0.5f);
    return code / 65535.0f;
}

/// The same of 1/255.
FN float rounded_to_unorm8(float x)
{
    PRECISE float code = floor(clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
    return code / 255.0f;
}

const float HALF_MAXIMUM = 65504.0f;
const float HALF_MIN_NORMAL = 6.10351562e-5f;   // 2^-14; below it halves are 2^-24 apart

/// x in [0, infinity) as the nearest half float, at most HALF_MAXIMUM.
FN float rounded_to_half(float x)
{
    PRECISE float bounded = min(x, HALF_MAXIMUM);
    PRECISE float scaled = 8193.0f * bounded;                 // 2^13 + 1 leaves 11 of 24 bits (Dekker)
    PRECISE float normal = scaled - (scaled - bounded);
    PRECISE float subnormal = (bounded + 0.5f) - 0.5f;        // floats in [.5, 1) are 2^-24 apart
    return bounded < HALF_MIN_NORMAL ? subnormal : normal;
}
