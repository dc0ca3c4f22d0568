// textbook_power.glsl -- Algorithm 1 as published (paper, Section 4): Cholesky decomposition, roots in closed form, divided
// differences. It is the baseline for speed, and it shows what bias is for: it divides by numbers that only the bias keeps from
// vanishing.

struct NormalisedMoments { float b[2 * ROOT_COUNT + 1]; };
struct LineNodes { float z[ORDER]; };         // z_0 = z_f, then the roots
struct LinePolynomial { float q[ORDER]; };    // sum of q_j z^j

/// q of Algorithm 1: the solution of H q = (1, z_f, z_f^2, ...), by LDL^T.
FN LinePolynomial kernel_of_hankel(IN(NormalisedMoments) moments, float depth)
{
    float lower[ORDER * ORDER];
    float inverse_pivot[ORDER];
    LinePolynomial polynomial;
    float power = 1.0f;
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        // An entry of lower is that of L D until its pivot is known.
        float sum = power;
        UNROLL
        for (int j = 0; j <= i; ++j)
        {
            float entry = moments.b[i + j];
            UNROLL
            for (int k = 0; k < j; ++k) entry = entry - lower[i * ORDER + k] * lower[j * ORDER + k] * inverse_pivot[k];
            lower[i * ORDER + j] = entry;
            if (j < i) sum = sum - entry * inverse_pivot[j] * polynomial.q[j];
        }
        inverse_pivot[i] = 1.0f / lower[i * ORDER + i];
        polynomial.q[i] = sum;
        power = power * depth;
    }
    UNROLL
    for (int i = ORDER - 1; i >= 0; --i)
    {
        float sum = polynomial.q[i] * inverse_pivot[i];
        UNROLL
        for (int j = i + 1; j < ORDER; ++j) sum = sum - lower[j * ORDER + i] * inverse_pivot[i] * polynomial.q[j];
        polynomial.q[i] = sum;
    }
    return polynomial;
}

struct TextbookPair { float first; float second; };

/// Roots of z^2 + p z + q.
FN TextbookPair textbook_quadratic(float p, float q)
{
    float half_gap = sqrt(0.25f * p * p - q);
    TextbookPair roots;
    roots.first = -0.5f * p - half_gap;
    roots.second = -0.5f * p + half_gap;
    return roots;
}

#if ROOT_COUNT >= 3
struct TextbookTriple { float first; float second; float third; };

/// The greatest root comes from one depressed form, the least from that of the reversed polynomial, and the middle one from both.
FN TextbookTriple textbook_cubic(float a, float b, float c, float d)
{
    float delta1 = a * c - b * b;
    float delta2 = a * d - b * c;
    float delta3 = b * d - c * c;
    float root = sqrt(4.0f * delta1 * delta3 - delta2 * delta2);
    const float SQRT3_HALF = 0.866025404f;

    float depressed_a = a * delta2 - 2.0f * b * delta1;
    float angle_a = abs(atan(a * root, -depressed_a)) / 3.0f;
    float scale_a = 2.0f * sqrt(-delta1);
    float a1 = scale_a * cos(angle_a);
    float a3 = scale_a * (-0.5f * cos(angle_a) - SQRT3_HALF * sin(angle_a));
    float great = (a1 + a3 > 2.0f * b ? a1 : a3) - b;   // divided by a below

    float depressed_d = 2.0f * c * delta3 - d * delta2;
    float angle_d = abs(atan(d * root, -depressed_d)) / 3.0f;
    float scale_d = 2.0f * sqrt(-delta3);
    float d1 = scale_d * cos(angle_d);
    float d3 = scale_d * (-0.5f * cos(angle_d) - SQRT3_HALF * sin(angle_d));
    float small = (d1 + d3 < 2.0f * c ? d1 : d3) + c;   // -d divided by this below

    float e = a * small;
    float f = a * d - great * small;
    float g = -great * d;
    TextbookTriple roots;
    roots.first = -d / small;
    roots.second = (c * f - b * g) / (c * e - b * f);
    roots.third = great / a;
    return roots;
}
#endif

/// z_f and the roots of q.
FN LineNodes nodes_of_kernel(IN(LinePolynomial) polynomial, float depth)
{
    LineNodes nodes;
    nodes.z[0] = depth;
    float inverse = 1.0f / polynomial.q[ROOT_COUNT];
#if ROOT_COUNT == 2
    TextbookPair pair = textbook_quadratic(polynomial.q[1] * inverse, polynomial.q[0] * inverse);
    nodes.z[1] = pair.first;
    nodes.z[2] = pair.second;
#elif ROOT_COUNT == 3
    TextbookTriple triple =
        textbook_cubic(1.0f, polynomial.q[2] * inverse / 3.0f, polynomial.q[1] * inverse / 3.0f, polynomial.q[0] * inverse);
    nodes.z[1] = triple.first;
    nodes.z[2] = triple.second;
    nodes.z[3] = triple.third;
#else
    float a = polynomial.q[3] * inverse;
    float b = polynomial.q[2] * inverse;
    float c = polynomial.q[1] * inverse;
    float d = polynomial.q[0] * inverse;
    // Neumark 1965: from the root y of least magnitude of the resolvent cubic, the quartic is split into two quadratics.
    TextbookTriple resolvent = textbook_cubic(1.0f, -2.0f * b / 3.0f, (a * c + b * b - 4.0f * d) / 3.0f,
                                              a * a * d - a * b * c + c * c);
    float y = abs(resolvent.second) < abs(resolvent.first) ? resolvent.second : resolvent.first;
    y = abs(resolvent.third) < abs(y) ? resolvent.third : y;
    // There are two ways to split. Take the one in which less cancels (Herbison-Evans 1995).
    float linear2 = a * a - 4.0f * y;
    float rest = b - y;
    float constant2 = rest * rest - 4.0f * d;
    bool by_linear = linear2 * (rest * rest + 4.0f * abs(d)) > constant2 * (a * a + 4.0f * abs(y));
    float linear_root = sqrt(linear2);
    float constant_root = sqrt(constant2);
    float mixed = a * rest - 2.0f * c;
    float linear_gap = by_linear ? linear_root : mixed / constant_root;
    float constant_gap = by_linear ? mixed / linear_root : constant_root;
    TextbookPair one = textbook_quadratic(0.5f * (a + linear_gap), 0.5f * (rest + constant_gap));
    TextbookPair two = textbook_quadratic(0.5f * (a - linear_gap), 0.5f * (rest - constant_gap));
    nodes.z[1] = one.first;
    nodes.z[2] = one.second;
    nodes.z[3] = two.first;
    nodes.z[4] = two.second;
#endif
    return nodes;
}

/// A(z_f, b, beta) / b_0 as Algorithm 1 returns it, not clamped; NaN if the algorithm breaks down. moments: not normalised.
FN float textbook_fraction(IN(Moments) moments, float depth, float bias, float overestimation, IN(Basis) basis)
{
    NormalisedMoments biased;
    biased.b[0] = 1.0f;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        float normalised = moments.b[i] / moments.b0;
        biased.b[i + 1] = normalised + bias * (bias_moment(i) - normalised);
    }
    LineNodes nodes = nodes_of_kernel(kernel_of_hankel(biased, depth), depth);
    // Divided differences give the polynomial that has the values v_l at the nodes. Its expectation is the result.
    float difference[ORDER];
    UNROLL
    for (int l = 0; l < ORDER; ++l) difference[l] = l == 0 ? overestimation : (nodes.z[l] < depth ? 1.0f : 0.0f);
    UNROLL
    for (int step = 1; step < ORDER; ++step)
    {
        UNROLL
        for (int l = ORDER - 1; l >= step; --l)
            difference[l] = (difference[l] - difference[l - 1]) / (nodes.z[l] - nodes.z[l - step]);
    }
    float coefficient[ORDER];
    UNROLL
    for (int j = 0; j < ORDER; ++j) coefficient[j] = j == 0 ? difference[ORDER - 1] : 0.0f;
    UNROLL
    for (int l = ORDER - 2; l >= 0; --l)
    {
        UNROLL
        for (int j = ORDER - 1; j >= 0; --j)
            coefficient[j] = (j == 0 ? difference[l] : coefficient[max(j - 1, 0)]) - nodes.z[l] * coefficient[j];
    }
    float fraction = coefficient[0];
    UNROLL
    for (int j = 1; j < ORDER; ++j) fraction = fraction + coefficient[j] * biased.b[j];
    return fraction;
}
