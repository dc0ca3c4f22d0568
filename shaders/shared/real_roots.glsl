// real_roots.glsl -- all roots of a polynomial whose roots are known to be real; degree ROOT_COUNT in 2..4, in closed form.
//
// The kernel polynomials come in t = 1/s, where s leads from the query depth to a node of the canonical
// representation (reconstruction.glsl): monic, t^n + e[0] t^(n-1) + ... + e[n-1]. A node at infinity is t = 0;
// a node close to the query, as when two fragments nearly tie, is one |t| that dwarfs the others. A closed form gives
// every root an error of a few ulps of the greatest. So one root at a time comes from it, and is divided out from
// the end that keeps the digits of the others.
// + - * / sqrt and fixed counts only: C++ vectorises it, and GLSL and C++ agree in every bit.

struct MonicPolynomial { float e[ROOT_COUNT]; };   // of t^(n-1), ..., t^0
struct Roots { float t[ROOT_COUNT]; };

struct RootPair { float first; float second; };

/// Roots of t^2 + e1 t + e2. A negative discriminant counts as 0. The larger root is computed without
/// cancellation, the other one from the product.
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

/// A cubic t^3 + e1 t^2 + e2 t + e3 with three real roots, depressed: t = shift + scale y, or shift - scale y, with
/// y^3 - 3 y = r, r in [0, 2].
struct DepressedCubic
{
    float shift;
    float scale;
    float r;
    float y;          // the greatest root, in [sqrt 3, 2], within 8e-6
    bool upwards;     // t = shift + scale y?
};

FN DepressedCubic depressed_cubic(float e1, float e2, float e3)
{
    PRECISE float shift = e1 * -0.333333333f;
    PRECISE float scale2 = max(shift * shift - e2 * 0.333333333f, 0.0f);
    PRECISE float scale = sqrt(scale2);
    PRECISE float constant = e3 + shift * (e2 - 2.0f * shift * shift);   // p(shift)
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
    // First the one that is farthest from the others, at least 1.7 scales away. A Newton step in t squares the error of 8e-6
    // scales. A step that is not small beside the scale is noise, as where all three coincide.
    PRECISE float offset = cubic.scale * cubic.y;
    PRECISE float lone = cubic.upwards ? cubic.shift + offset : cubic.shift - offset;
    PRECISE float slope = (3.0f * lone + 2.0f * e1) * lone + e2;
    PRECISE float step_size = (((lone + e1) * lone + e2) * lone + e3) / slope;
    lone = abs(step_size) < 0.25f * cubic.scale ? lone - step_size : lone;
    // Then t^2 + d1 t + d2, divided out from the constant term up if the lone root lies beyond the mean as seen from 0, and
    // else from the leading term down.
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
/// If the squares of a quartic's roots sum to between 2/3 and 4, its root of greatest magnitude is at least .4, and its
/// coefficients are at most 4, 6, 4 and 1. These limits keep all other quartics finite, whose roots are all but 0 or not real.
const float MIN_FAR_ROOT = 0.1f;
const float MAX_SCALED = 16.0f;

/// The greatest root of a cubic with three real ones.
FN float greatest_root(float e1, float e2, float e3)
{
    DepressedCubic cubic = depressed_cubic(e1, e2, e3);
    PRECISE float y = (2.0f * cubic.y * cubic.y * cubic.y + cubic.r) / (3.0f * cubic.y * cubic.y - 3.0f);   // Newton
    PRECISE float half_gap = 0.5f * sqrt(max(12.0f - 3.0f * y * y, 0.0f));
    PRECISE float root = cubic.shift + cubic.scale * (cubic.upwards ? y : 0.5f * y + half_gap);
    return root;
}

/// The root of greatest magnitude of a quartic with four real ones (Ferrari). Of the depressed quartic
/// y^4 + c2 y^2 + c1 y + c0 the two upper roots sum to m, the two lower ones to -m, and m^2 is the greatest root of the
/// resolvent cubic.
FN float far_root(IN(MonicPolynomial) p)
{
    PRECISE float shift = -0.25f * p.e[0];
    PRECISE float shift2 = shift * shift;
    PRECISE float c2 = p.e[1] - 6.0f * shift2;
    PRECISE float c1 = p.e[2] + shift * (2.0f * p.e[1] - 8.0f * shift2);
    PRECISE float c0 = p.e[3] + shift * (p.e[2] + shift * (p.e[1] - 3.0f * shift2));
    PRECISE float m2 = max(greatest_root(2.0f * c2, c2 * c2 - 4.0f * c0, -c1 * c1), 0.0f);
    PRECISE float m = sqrt(m2);
    // The squared gaps of the pairs are spread -+ skew, so that neither exceeds the other's sum.
    PRECISE float spread = max(-m2 - 2.0f * c2, 0.0f);
    float skew = m > 0.0f ? clamp(2.0f * c1 / m, -spread, spread) : 0.0f;
    PRECISE float upper = shift + 0.5f * (m + sqrt(spread - skew));
    PRECISE float lower = shift - 0.5f * (m + sqrt(spread + skew));
    return upper + lower > 0.0f ? upper : lower;
}

/// Improves all roots at once (Ehrlich and Aberth): a Newton step that the other roots repel. A step that
/// would be as large as the gap to another root is noise and not taken.
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

/// All roots of a quartic whose roots' squares sum to between 2/3 and 4.
FN Roots quartic_roots(IN(MonicPolynomial) p)
{
    float root = far_root(p);
    float far = abs(root) < MIN_FAR_ROOT ? MIN_FAR_ROOT : root;
    // From the constant term up: t^4 + ... = (t - far) (t^3 + d1 t^2 + d2 t + d3).
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

/// All roots of p, which must be real; those of a slightly indefinite p come out as a nearby real set.
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
    // Scaled by a power of two, which is exact, so that no power over- or underflows. Coefficients beyond the limit belong to
    // roots that are not real, whose squares may even sum to less than 0.
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
