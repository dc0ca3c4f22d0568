// portable_math.glsl -- log, exp and sincos, computed with + - * / only, so that a GL driver and a C++ compiler get the same bits.
// Built-in functions differ by up to 1e-4 (docs/glsl-subset.md).

const float PI = 3.14159265f;
const float LN2_HIGH = 0.693359375f;        // 355/512: n * LN2_HIGH is exact for |n| < 2^14
const float LN2_LOW = -2.12194440e-4f;      // ln 2 - LN2_HIGH

/// ln((1 + f) 2^e) for 1 + f in [sqrt(1/2), sqrt 2]. With s = f / (2 + f), ln(1 + f) = 2 atanh(s) = 2 (s + s^3/3 + s^5/5 + ...).
/// The series is cut where the rest is 2e-9 (relative).
FN float log_of_parts(float f, float e)
{
    PRECISE float s = f / (2.0f + f);
    PRECISE float s2 = s * s;
    PRECISE float series = s2 * (0.333333333f + s2 * (0.2f + s2 * (0.142857143f + s2 * 0.111111111f)));
    PRECISE float log_mantissa = 2.0f * s + 2.0f * s * series;
    PRECISE float result = e * LN2_HIGH + (log_mantissa + e * LN2_LOW);
    return result;
}

/// The exponent e with x 2^-e in [sqrt(1/2), sqrt 2). x: positive, normal.
FN int balanced_exponent(float x)
{
    return (floatBitsToInt(x) - 0x3f3504f3) >> 23;   // 0x3f3504f3 = bits of sqrt(1/2)
}

/// The power of two 2^-e with x 2^-e in [1, 2). x: positive, normal, below 2^126.
FN float inverse_power_of_two(float x)
{
    return intBitsToFloat((254 - (floatBitsToInt(x) >> 23)) << 23);
}

/// inverse_power_of_two of sqrt(x), from half of the exponent of x. x: positive, normal.
FN float inverse_power_of_root(float x)
{
    return intBitsToFloat((254 - ((floatBitsToInt(x) >> 23) + 127) / 2) << 23);
}

/// Natural logarithm of x > 0, which must be normal. Error: 2 ulp, or 1e-7 where the result is near 0.
FN float portable_log(float x)
{
    int e = balanced_exponent(x);
    float mantissa = intBitsToFloat(floatBitsToInt(x) - (e << 23));
    return log_of_parts(mantissa - 1.0f, float(e));
}

/// -ln(1 - x) for x in [0, 1). Accurate also for tiny x, where 1 - x has lost the digits of x.
FN float negative_log_one_minus(float x)
{
    PRECISE float rest = 1.0f - x;
    int e = balanced_exponent(rest);
    float mantissa = intBitsToFloat(floatBitsToInt(rest) - (e << 23));
    float f = e == 0 ? -x : mantissa - 1.0f;   // x itself has the digits that 1 - x has lost
    return -log_of_parts(f, float(e));
}

/// e^x. x is clamped to [-87, 88], so the result stays a normal float. Error: 2 ulp.
///
/// With n = round(x / ln 2) and r = x - n ln 2, e^x = 2^n e^r, and e^r is its Taylor series.
FN float portable_exp(float x)
{
    PRECISE float bounded = clamp(x, -87.0f, 88.0f);
    PRECISE float n = floor(bounded * 1.44269504f + 0.5f);
    PRECISE float r = (bounded - n * LN2_HIGH) - n * LN2_LOW;   // |r| <= ln(2) / 2
    PRECISE float tail = 1.66666667e-1f
        + r * (4.16666667e-2f + r * (8.33333333e-3f + r * (1.38888889e-3f + r * 1.98412698e-4f)));
    PRECISE float power = 1.0f + (r + r * r * (0.5f + r * tail));
    PRECISE float result = power * intBitsToFloat((int(n) + 127) << 23);
    return result;
}

struct SinCos { float sine; float cosine; };

/// sin and cos of an angle in [0, pi]. Absolute error below 2.2e-7. Uses the Taylor series about pi/2, where the sine is even and
/// the cosine is odd.
FN SinCos portable_sincos(float angle)
{
    PRECISE float y = (angle - 1.57079637f) + 4.37113883e-8f;   // pi/2 in two parts
    PRECISE float y2 = y * y;
    PRECISE float even = y2 * (-0.5f + y2 * (4.16666667e-2f + y2 * (-1.38888889e-3f
        + y2 * (2.48015873e-5f + y2 * (-2.75573192e-7f + y2 * 2.08767570e-9f)))));
    PRECISE float odd = y * y2 * (-1.66666667e-1f + y2 * (8.33333333e-3f + y2 * (-1.98412698e-4f
        + y2 * (2.75573192e-6f + y2 * (-2.50521084e-8f + y2 * 1.60590438e-10f)))));
    SinCos result;
    result.sine = 1.0f + even;
    result.cosine = -(y + odd);
    return result;
}
