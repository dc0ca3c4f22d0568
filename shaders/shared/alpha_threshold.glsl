// alpha_threshold.glsl -- the threshold of hashed alpha testing (Wyman and McGuire 2017, Section 3). It is a hash of the place on
// the object, so it moves with the object. The place is rounded to cells about as large as a pixel. To get there, two hashes are
// interpolated, for the two powers of two next to the scale of the object on the screen. Then the result is made uniform again.

const float TWO_PI = 2.0f * PI;
const float MIN_THRESHOLD = 1.0e-6f;

FN float fraction_of(float x)
{
    return x - floor(x);
}

/// sin of any angle, for hashing only. The error may be large where the angle is large.
FN float hashing_sine(float angle)
{
    PRECISE float turns = angle / TWO_PI;
    PRECISE float within = min(max(angle - TWO_PI * floor(turns), 0.0f), TWO_PI);
    PRECISE float beyond = within - PI;
    return within > PI ? -portable_sincos(beyond).sine : portable_sincos(within).sine;
}

/// A hash of x and y, in [0, 1).
FN float hash_of_two(float x, float y)
{
    PRECISE float a = 17.0f * x + 0.1f * y;
    PRECISE float b = 13.0f * y + x;
    PRECISE float scaled = 1.0e4f * hashing_sine(a) * (0.1f + abs(hashing_sine(b)));
    return fraction_of(scaled);
}

FN float hash_of_place(float x, float y, float z, float scale)
{
    return hash_of_two(hash_of_two(floor(scale * x), floor(scale * y)), floor(scale * z));
}

/// The distribution function of (1 - a) u + a v, where u and v are uniform in [0, 1] and independent. a in [0, 1/2]. The result is
/// the probability that the mean lies below x, so it maps the mean to a uniform number.
FN float distribution_of_mean(float x, float a)
{
    if (a < 1.0e-6f) return x;
    float tail = 2.0f * a * (1.0f - a);
    if (x < a) return x * x / tail;
    if (x < 1.0f - a) return (x - 0.5f * a) / (1.0f - a);
    return 1.0f - (1.0f - x) * (1.0f - x) / tail;
}

/// The threshold in [1e-6, 1]. x, y, z: the place in object space. width: how far this place moves at most from one pixel to the
/// next, > 0.
FN float alpha_threshold(float x, float y, float z, float width)
{
    PRECISE float scale = 1.0f / max(width, 1.0e-20f);
    float power = 1.0f / inverse_power_of_two(scale);                       // 2^floor(log2 scale)
    float between = portable_log(scale / power) * 1.44269504f;
    PRECISE float mean = (1.0f - between) * hash_of_place(x, y, z, power) + between * hash_of_place(x, y, z, 2.0f * power);
    return clamp(distribution_of_mean(mean, min(between, 1.0f - between)), MIN_THRESHOLD, 1.0f);
}
