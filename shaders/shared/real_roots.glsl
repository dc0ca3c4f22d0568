// real_roots.glsl -- all roots of a polynomial whose roots are known to be real; degree ROOT_COUNT in 2..4.
//
// The kernel polynomials come in t = 1/s, where s leads from the query depth to a node of the canonical
// representation (reconstruction.glsl): monic, t^n + e[0] t^(n-1) + ... + e[n-1]. A node at infinity is t = 0;
// a node close to the query, as when two fragments nearly tie, is one |t| that dwarfs the others. So that one
// is found first, and deflated from the other end, which keeps the digits of the small ones.
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
/// How often to step after the first: convergence is cubic, but slow until two roots that lie close together are told
/// apart (docs/tolerances.md).
const int LAGUERRE_STEPS = 5;

/// One Laguerre step for the root of least |s| of 1 + e[0] s + ... + e[n-1] s^n.
FN float laguerre_step(IN(MonicPolynomial) p, float s)
{
    PRECISE float value = p.e[ROOT_COUNT - 1];
    PRECISE float slope = 0.0f;
    PRECISE float half_curvature = 0.0f;
    UNROLL
    for (int k = ROOT_COUNT - 2; k >= -1; --k)
    {
        half_curvature = half_curvature * s + slope;
        slope = slope * s + value;
        value = value * s + (k < 0 ? 1.0f : p.e[max(k, 0)]);
    }
    const float n = float(ROOT_COUNT);
    PRECISE float discriminant = (n - 1.0f) * (n - 1.0f) * slope * slope
        - 2.0f * n * (n - 1.0f) * value * half_curvature;
    PRECISE float root = sqrt(max(discriminant, 0.0f));
    PRECISE float denominator = slope < 0.0f ? slope - root : slope + root;
    PRECISE float next = s - n * value / denominator;
    return denominator == 0.0f ? s : next;
}

/// The s of least magnitude. If all roots lie at infinity, s is so large that 1/s counts as 0.
FN float nearest_root(IN(MonicPolynomial) p)
{
    const float n = float(ROOT_COUNT);
    // The first step from s = 0 in terms of t = 1/s, because s itself may be infinite.
    PRECISE float root = sqrt(max((n - 1.0f) * (n - 1.0f) * p.e[0] * p.e[0]
                                  - 2.0f * n * (n - 1.0f) * p.e[1], 0.0f));
    PRECISE float t = (p.e[0] < 0.0f ? root - p.e[0] : -root - p.e[0]) / n;
    float s = abs(t) < 1.0e-6f ? 1.0e6f : 1.0f / t;
    // Steps shrink until, within a close pair, value and slope are rounding noise; then a step may lead anywhere.
    float last_size = 1.0e30f;
    UNROLL
    for (int i = 0; i < LAGUERRE_STEPS; ++i)
    {
        float next = laguerre_step(p, s);
        float size = abs(next - s);
        s = size < last_size ? next : s;
        last_size = min(size, last_size);
    }
    return s;
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
#endif

#if ROOT_COUNT == 4
struct RootTriple { float first; float second; float third; };

/// Roots of t^3 + e1 t^2 + e2 t + e3, all real. Depressed and scaled to y^3 - 3 y = r with r in [0, 2],
/// whose largest root lies in [sqrt 3, 2]: the chord there is at most .002 off, and three Newton steps
/// exhaust a float.
FN RootTriple cubic_roots(float e1, float e2, float e3)
{
    PRECISE float shift = e1 * -0.333333333f;
    PRECISE float scale2 = max(shift * shift - e2 * 0.333333333f, 0.0f);
    PRECISE float scale = sqrt(scale2);
    PRECISE float constant = e3 + shift * (e2 - 2.0f * shift * shift);   // p(shift)
    PRECISE float cube = scale2 * scale;
    float r = cube > 0.0f ? min(abs(constant) / cube, 2.0f) : 0.0f;
    PRECISE float y = 1.73205081f + 0.133974596f * r;
    UNROLL
    for (int i = 0; i < 3; ++i) y = y - (y * (y * y - 3.0f) - r) / (3.0f * y * y - 3.0f);
    PRECISE float half_gap = 0.5f * sqrt(max(12.0f - 3.0f * y * y, 0.0f));
    float direction = constant > 0.0f ? -scale : scale;
    RootTriple roots;
    roots.first = shift + direction * y;
    roots.second = shift + direction * (-0.5f * y - half_gap);
    roots.third = shift + direction * (-0.5f * y + half_gap);
    return roots;
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
    return roots;
#else
    float s = nearest_root(p);
    // Deflation from the constant term up: t^n + ... = (t - 1/s) (t^(n-1) + d1 t^(n-2) + ...), d_k-1 = (d_k - e_k) s.
#if ROOT_COUNT == 3
    PRECISE float d2 = -p.e[2] * s;
    PRECISE float d1 = (d2 - p.e[1]) * s;
    RootPair pair = quadratic_roots(d1, d2);
    roots.t[0] = 1.0f / s;
    roots.t[1] = pair.first;
    roots.t[2] = pair.second;
#else
    PRECISE float d3 = -p.e[3] * s;
    PRECISE float d2 = (d3 - p.e[2]) * s;
    PRECISE float d1 = (d2 - p.e[1]) * s;
    RootTriple triple = cubic_roots(d1, d2, d3);
    roots.t[0] = 1.0f / s;
    roots.t[1] = triple.first;
    roots.t[2] = triple.second;
    roots.t[3] = triple.third;
#endif
    return polished_roots(p, roots);
#endif
}
