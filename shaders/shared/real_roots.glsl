// real_roots.glsl -- all roots of a polynomial that has only real roots, in closed form. Its degree is ROOT_COUNT, in 2..4.
//
// The variable of a kernel polynomial is t = 1/s, where s is the distance from the query depth to a node of the canonical
// representation (reconstruction.glsl). The polynomial is monic: t^n + e[0] t^(n-1) + ... + e[n-1]. A node at infinity has t = 0.
// If two fragments nearly coincide, a node is close to the query, and its |t| is much larger than all others. A closed form gives
// every root an error of a few ulps of the largest root. So it is used for one root at a time. This root is divided out, starting
// at the end of the polynomial that keeps the digits of the other roots.
// Only + - * / sqrt and fixed counts are used, so C++ can vectorise it, and GLSL and C++ agree in every bit.

struct MonicPolynomial { float e[ROOT_COUNT]; };   // coefficients of t^(n-1), ..., t^0
struct Roots { float t[ROOT_COUNT]; };

struct RootPair { float first; float second; };

/// Roots of t^2 + e1 t + e2. A negative discriminant counts as 0. The root of larger magnitude comes first, computed without
/// cancellation. The other follows from their product e2.
FN RootPair quadratic_roots(float e1, float e2)
{
    PRECISE float half_sum = -0.5f * e1;
    PRECISE float half_gap = sqrt(max(half_sum * half_sum - e2, 0.0f));
    RootPair roots;
    roots.first = half_sum < 0.0f ? half_sum - half_gap : half_sum + half_gap;
    roots.second = roots.first == 0.0f ? 0.0f : e2 / roots.first;
    return roots;
}

#if ROOT_COUNT >= 3
struct RootTriple { float first; float second; float third; };

/// A cubic t^3 + e1 t^2 + e2 t + e3 with three real roots in its depressed form: t = shift + scale y, or t = shift - scale y, with
/// y^3 - 3 y = r and r in [0, 2].
///
/// With shift = -e1/3, the quadratic term vanishes. With scale^2 = shift^2 - e2/3, the cubic is scale^3 (y^3 - 3 y) plus its value
/// at shift. So r is the magnitude of this value over scale^3, and its sign decides the direction of y.
struct DepressedCubic
{
    float shift;
    float scale;
    float r;
    float y;          // the greatest root of y^3 - 3 y = r, in [sqrt 3, 2]; error 8e-6
    bool upwards;     // true: t = shift + scale y; false: t = shift - scale y
};

FN DepressedCubic depressed_cubic(float e1, float e2, float e3)
{
    PRECISE float shift = e1 * -0.333333333f;
    PRECISE float scale2 = max(shift * shift - e2 * 0.333333333f, 0.0f);
    PRECISE float scale = sqrt(scale2);
    PRECISE float constant = e3 + shift * (e2 - 2.0f * shift * shift);   // the cubic at shift
    PRECISE float cube = scale2 * scale;
    float r = cube > 0.0f ? min(abs(constant) / cube, 2.0f) : 0.0f;
    PRECISE float y = 1.73205868f + r * (0.166445376f + r * (-0.0230434543f + r * (0.00444321459f - r * 0.000520575373f)));
    DepressedCubic cubic;
    cubic.shift = shift;
    cubic.scale = scale;
    cubic.r = r;
    cubic.y = y;
    cubic.upwards = !(constant > 0.0f);
    return cubic;
}

/// All roots of t^3 + e1 t^2 + e2 t + e3, which must be real.
FN RootTriple cubic_roots(float e1, float e2, float e3)
{
    DepressedCubic cubic = depressed_cubic(e1, e2, e3);
    // First, the root that is farthest from the others. It is at least 1.7 scales away from them. A Newton step in t squares its
    // error of 8e-6 scales. A step that is not small compared with the scale is noise, as happens if all three roots coincide.
    PRECISE float offset = cubic.scale * cubic.y;
    PRECISE float lone = cubic.upwards ? cubic.shift + offset : cubic.shift - offset;
    PRECISE float slope = (3.0f * lone + 2.0f * e1) * lone + e2;
    PRECISE float step_size = (((lone + e1) * lone + e2) * lone + e3) / slope;
    lone = abs(step_size) < 0.25f * cubic.scale ? lone - step_size : lone;
    // Then divide it out, which leaves t^2 + d1 t + d2. If the root is farther from 0 than the mean of all three, start from the
    // constant term; otherwise start from the leading term.
    PRECISE float inverse = 1.0f / lone;
    PRECISE float up2 = -e3 * inverse;
    PRECISE float up1 = (up2 - e2) * inverse;
    PRECISE float down1 = e1 + lone;
    PRECISE float down2 = e2 + lone * down1;
    bool beyond = abs(lone) > abs(cubic.shift);
    RootPair pair = quadratic_roots(beyond ? up1 : down1, beyond ? up2 : down2);
    RootTriple roots;
    roots.first = lone;
    roots.second = pair.first;
    roots.third = pair.second;
    return roots;
}
#endif

#if ROOT_COUNT == 4
/// If the squares of the roots of a quartic sum to between 2/3 and 4, its root of largest magnitude is at least 0.4, and its
/// coefficients are at most 4, 6, 4 and 1. All other quartics have roots that are nearly all 0, or not real. These limits keep them
/// finite.
const float MIN_FAR_ROOT = 0.1f;
const float MAX_SCALED = 16.0f;

/// The greatest root of a cubic with three real roots.
FN float greatest_root(float e1, float e2, float e3)
{
    DepressedCubic cubic = depressed_cubic(e1, e2, e3);
    PRECISE float y = (2.0f * cubic.y * cubic.y * cubic.y + cubic.r) / (3.0f * cubic.y * cubic.y - 3.0f);   // Newton
    PRECISE float half_gap = 0.5f * sqrt(max(12.0f - 3.0f * y * y, 0.0f));
    PRECISE float root = cubic.shift + cubic.scale * (cubic.upwards ? y : 0.5f * y + half_gap);
    return root;
}

/// The root of largest magnitude of a quartic with four real roots (Ferrari).
///
/// The depressed quartic y^4 + c2 y^2 + c1 y + c0 is (y^2 - m y + u) (y^2 + m y + v), where m is the sum of the two upper roots. So
/// u + v = c2 + m^2, u - v = c1 / m and u v = c0. This makes m^2 the greatest root of the resolvent cubic
/// x^3 + 2 c2 x^2 + (c2^2 - 4 c0) x - c1^2.
FN float far_root(IN(MonicPolynomial) p)
{
    PRECISE float shift = -0.25f * p.e[0];
    PRECISE float shift2 = shift * shift;
    PRECISE float c2 = p.e[1] - 6.0f * shift2;
    PRECISE float c1 = p.e[2] + shift * (2.0f * p.e[1] - 8.0f * shift2);
    PRECISE float c0 = p.e[3] + shift * (p.e[2] + shift * (p.e[1] - 3.0f * shift2));
    PRECISE float m2 = max(greatest_root(2.0f * c2, c2 * c2 - 4.0f * c0, -c1 * c1), 0.0f);
    PRECISE float m = sqrt(m2);
    // The squared gaps of the two pairs are -m^2 - 2 c2 -+ 2 c1 / m. Neither is negative, which limits the second term.
    PRECISE float spread = max(-m2 - 2.0f * c2, 0.0f);
    float skew = m > 0.0f ? clamp(2.0f * c1 / m, -spread, spread) : 0.0f;
    PRECISE float upper = shift + 0.5f * (m + sqrt(spread - skew));
    PRECISE float lower = shift - 0.5f * (m + sqrt(spread + skew));
    return upper + lower > 0.0f ? upper : lower;
}

/// Improves all roots at once (Ehrlich and Aberth): one Newton step in which the other roots repel. A step of at least half the gap
/// to the nearest other root is noise and is not taken.
FN Roots polished_roots(IN(MonicPolynomial) p, IN(Roots) roots)
{
    float repulsion[ROOT_COUNT];
    float least_gap[ROOT_COUNT];
    UNROLL
    for (int i = 0; i < ROOT_COUNT; ++i)
    {
        repulsion[i] = 0.0f;
        least_gap[i] = 1.0e30f;
    }
    UNROLL
    for (int i = 1; i < ROOT_COUNT; ++i)
    {
        UNROLL
        for (int j = 0; j < i; ++j)
        {
            float gap = roots.t[i] - roots.t[j];
            float push = gap == 0.0f ? 0.0f : 1.0f / gap;
            repulsion[i] = repulsion[i] + push;
            repulsion[j] = repulsion[j] - push;
            least_gap[i] = min(least_gap[i], abs(gap));
            least_gap[j] = min(least_gap[j], abs(gap));
        }
    }
    Roots result;
    UNROLL
    for (int i = 0; i < ROOT_COUNT; ++i)
    {
        float t = roots.t[i];
        PRECISE float value = 1.0f;
        PRECISE float slope = 0.0f;
        UNROLL
        for (int k = 0; k < ROOT_COUNT; ++k)
        {
            slope = slope * t + value;
            value = value * t + p.e[k];
        }
        PRECISE float denominator = slope - value * repulsion[i];
        PRECISE float step_size = value / denominator;
        result.t[i] = denominator != 0.0f && abs(step_size) < 0.5f * least_gap[i] ? t - step_size : t;
    }
    return result;
}

/// All roots of a quartic. The squares of its roots must sum to between 2/3 and 4.
FN Roots quartic_roots(IN(MonicPolynomial) p)
{
    float root = far_root(p);
    float far = abs(root) < MIN_FAR_ROOT ? MIN_FAR_ROOT : root;
    // Divided out from the constant term: t^4 + ... = (t - far) (t^3 + d1 t^2 + d2 t + d3).
    PRECISE float s = 1.0f / far;
    PRECISE float d3 = -p.e[3] * s;
    PRECISE float d2 = (d3 - p.e[2]) * s;
    PRECISE float d1 = (d2 - p.e[1]) * s;
    RootTriple triple = cubic_roots(d1, d2, d3);
    Roots roots;
    roots.t[0] = far;
    roots.t[1] = triple.first;
    roots.t[2] = triple.second;
    roots.t[3] = triple.third;
    return polished_roots(p, roots);
}
#endif

/// All roots of p, which must be real. If rounding made some of them slightly complex, the result is a real set nearby.
FN Roots real_roots(IN(MonicPolynomial) p)
{
    Roots roots;
#if ROOT_COUNT == 2
    RootPair pair = quadratic_roots(p.e[0], p.e[1]);
    roots.t[0] = pair.first;
    roots.t[1] = pair.second;
#elif ROOT_COUNT == 3
    RootTriple triple = cubic_roots(p.e[0], p.e[1], p.e[2]);
    roots.t[0] = triple.first;
    roots.t[1] = triple.second;
    roots.t[2] = triple.third;
#else
    // The roots are scaled by a power of two, which is exact, so that no power overflows or underflows. Coefficients beyond
    // MAX_SCALED belong to roots that are not real. The squares of such roots may even have a negative sum.
    PRECISE float squares = p.e[0] * p.e[0] - 2.0f * p.e[1];
    float unit = inverse_power_of_root(clamp(max(squares, abs(p.e[1])), 1.0e-12f, 1.0e30f));
    MonicPolynomial scaled;
    PRECISE float power = unit;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        scaled.e[k] = clamp(p.e[k] * power, -MAX_SCALED, MAX_SCALED);
        power = power * unit;
    }
    roots = quartic_roots(scaled);
    float size = 1.0f / unit;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) roots.t[l] = roots.t[l] * size;
#endif
    return roots;
}
