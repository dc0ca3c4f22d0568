// rounding.glsl -- rounds numbers to what a texture of few bits can hold. Rounding is done here, not by the texture unit. The unit
// then writes numbers that it can hold exactly, so the bits are the same everywhere.

/// x rounded to the nearest multiple of 1/65535, clamped to [0, 1]. A texture unit stores and returns such a number unchanged.
FN float rounded_to_unorm16(float x)
{
    PRECISE float code = floor(clamp(x, 0.0f, 1.0f) * 65535.0f + 0.5f);
    return code / 65535.0f;
}

/// The same with multiples of 1/255.
FN float rounded_to_unorm8(float x)
{
    PRECISE float code = floor(clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
    return code / 255.0f;
}

const float HALF_MAXIMUM = 65504.0f;
const float HALF_MIN_NORMAL = 6.10351562e-5f;   // 2^-14; smaller half floats are 2^-24 apart

/// x >= 0 rounded to the nearest half float, at most HALF_MAXIMUM.
FN float rounded_to_half(float x)
{
    PRECISE float bounded = min(x, HALF_MAXIMUM);
    PRECISE float scaled = 8193.0f * bounded;                 // times 2^13 + 1: leaves 11 of 24 bits (Dekker)
    PRECISE float normal = scaled - (scaled - bounded);
    PRECISE float subnormal = (bounded + 0.5f) - 0.5f;        // floats in [0.5, 1) are 2^-24 apart
    return bounded < HALF_MIN_NORMAL ? subnormal : normal;
}
