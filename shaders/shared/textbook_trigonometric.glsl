// textbook_trigonometric.glsl -- Algorithm 2 as published (paper, Section 5): the same steps as Algorithm 1 with complex numbers.

struct CircleNodes { Complex x[ORDER]; };         // x_0 = x(z_f), then the roots
struct CirclePolynomial { Complex q[ORDER]; };

FN Complex sum(IN(Complex) a, IN(Complex) b)
{
    return make_complex(a.re + b.re, a.im + b.im);
}

FN Complex difference(IN(Complex) a, IN(Complex) b)
{
    return make_complex(a.re - b.re, a.im - b.im);
}

FN Complex scaled(IN(Complex) a, float scale)
{
    return make_complex(a.re * scale, a.im * scale);
}

FN Complex quotient(IN(Complex) a, IN(Complex) b)
{
    return scaled(product(a, conjugate(b)), 1.0f / (b.re * b.re + b.im * b.im));
}

FN float squared_length(IN(Complex) a)
{
    return a.re * a.re + a.im * a.im;
}

/// The square root whose real part is not negative.
FN Complex square_root(IN(Complex) a)
{
    float length = sqrt(squared_length(a));
    float re = sqrt(max(0.5f * (length + a.re), 0.0f));
    float im = sqrt(max(0.5f * (length - a.re), 0.0f));
    return make_complex(re, a.im < 0.0f ? -im : im);
}

/// One of the three cube roots.
FN Complex cube_root(IN(Complex) a)
{
    float length = pow(squared_length(a), 1.0f / 6.0f);
    float angle = atan(a.im, a.re) / 3.0f;
    return make_complex(length * cos(angle), length * sin(angle));
}

/// b_i of a Toeplitz matrix; for negative i the conjugate of b_{-i}.
FN Complex toeplitz_moment(IN(CirclePolynomial) b, int i)
{
    Complex q = b.q[max(i, -i)];
    return make_complex(q.re, i < 0 ? -q.im : q.im);
}

/// q of Algorithm 2: the solution of G q = (1, x_0, x_0^2, ...) with G_ij = b_{i-j}, by LDL^H.
FN CirclePolynomial kernel_of_toeplitz(IN(CirclePolynomial) b, IN(Complex) x0)
{
    Complex lower[ORDER * ORDER];   // an entry is that of L D until its pivot is known
    float inverse_pivot[ORDER];
    CirclePolynomial polynomial;
    Complex power = make_complex(1.0f, 0.0f);
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        Complex rest = power;
        UNROLL
        for (int j = 0; j <= i; ++j)
        {
            Complex entry = toeplitz_moment(b, i - j);
            UNROLL
            for (int k = 0; k < j; ++k)
                entry = difference(entry, scaled(product(lower[i * ORDER + k], conjugate(lower[j * ORDER + k])),
                                                 inverse_pivot[k]));
            lower[i * ORDER + j] = entry;
            if (j < i) rest = difference(rest, scaled(product(entry, polynomial.q[j]), inverse_pivot[j]));
        }
        inverse_pivot[i] = 1.0f / lower[i * ORDER + i].re;
        polynomial.q[i] = rest;
        power = product(power, x0);
    }
    UNROLL
    for (int i = ORDER - 1; i >= 0; --i)
    {
        Complex rest = scaled(polynomial.q[i], inverse_pivot[i]);
        UNROLL
        for (int j = i + 1; j < ORDER; ++j)
            rest = difference(
                rest, product(scaled(conjugate(lower[j * ORDER + i]), inverse_pivot[i]), polynomial.q[j]));
        polynomial.q[i] = rest;
    }
    return polynomial;
}

struct ComplexPair { Complex first; Complex second; };

/// Roots of x^2 + p x + q.
FN ComplexPair complex_quadratic(IN(Complex) p, IN(Complex) q)
{
    Complex half_sum = scaled(p, -0.5f);
    Complex half_gap = square_root(difference(product(half_sum, half_sum), q));
    ComplexPair roots;
    roots.first = difference(half_sum, half_gap);
    roots.second = sum(half_sum, half_gap);
    return roots;
}

#if ROOT_COUNT >= 3
struct ComplexTriple { Complex first; Complex second; Complex third; };

/// Roots of x^3 + a x^2 + b x + c by Cardano's formula.
FN ComplexTriple complex_cubic(IN(Complex) a, IN(Complex) b, IN(Complex) c)
{
    Complex shift = scaled(a, -1.0f / 3.0f);
    Complex p = sum(scaled(b, 1.0f / 3.0f), scaled(product(shift, shift), -1.0f));   // of y^3 + 3 p y + 2 q, with x = shift + y
    Complex q = scaled(sum(c, product(shift, difference(b, scaled(product(shift, shift), 2.0f)))), 0.5f);
    Complex root = square_root(sum(product(q, q), product(p, product(p, p))));
    Complex one = difference(root, q);
    Complex two = scaled(sum(root, q), -1.0f);
    Complex u = cube_root(choose_complex(squared_length(one) > squared_length(two), one, two));
    Complex v = scaled(quotient(p, u), -1.0f);
    const float SQRT3_HALF = 0.866025404f;
    Complex half_sum = scaled(sum(u, v), -0.5f);
    Complex gap = scaled(difference(u, v), SQRT3_HALF);
    Complex turned = make_complex(-gap.im, gap.re);
    ComplexTriple roots;
    roots.first = sum(shift, sum(u, v));
    roots.second = sum(shift, sum(half_sum, turned));
    roots.third = sum(shift, difference(half_sum, turned));
    return roots;
}
#endif

/// x_0 and the roots of sum conj(q_j) x^j. The text of the paper lost these conjugates; without them, weights are negative.
FN CircleNodes nodes_of_circle_kernel(IN(CirclePolynomial) polynomial, IN(Complex) x0)
{
    CircleNodes nodes;
    nodes.x[0] = x0;
    Complex leading = conjugate(polynomial.q[ROOT_COUNT]);
    CirclePolynomial monic;
    UNROLL
    for (int j = 0; j < ROOT_COUNT; ++j) monic.q[j] = quotient(conjugate(polynomial.q[j]), leading);
#if ROOT_COUNT == 2
    ComplexPair pair = complex_quadratic(monic.q[1], monic.q[0]);
    nodes.x[1] = pair.first;
    nodes.x[2] = pair.second;
#elif ROOT_COUNT == 3
    ComplexTriple triple = complex_cubic(monic.q[2], monic.q[1], monic.q[0]);
    nodes.x[1] = triple.first;
    nodes.x[2] = triple.second;
    nodes.x[3] = triple.third;
#else
    // Neumark's resolvent with complex coefficients.
    Complex a = monic.q[3];
    Complex b = monic.q[2];
    Complex c = monic.q[1];
    Complex d = monic.q[0];
    Complex ac = product(a, c);
    ComplexTriple resolvent = complex_cubic(
        scaled(b, -2.0f), difference(sum(ac, product(b, b)), scaled(d, 4.0f)),
        sum(difference(product(product(a, a), d), product(b, ac)), product(c, c)));
    // Any root y will do. The one with the largest radicand cancels least.
    Complex y = resolvent.first;
    Complex linear2 = difference(product(a, a), scaled(y, 4.0f));
    Complex other = difference(product(a, a), scaled(resolvent.second, 4.0f));
    bool better = squared_length(other) > squared_length(linear2);
    y = choose_complex(better, resolvent.second, y);
    linear2 = choose_complex(better, other, linear2);
    other = difference(product(a, a), scaled(resolvent.third, 4.0f));
    better = squared_length(other) > squared_length(linear2);
    y = choose_complex(better, resolvent.third, y);
    linear2 = choose_complex(better, other, linear2);
    Complex gap = square_root(linear2);
    Complex rest = difference(b, y);
    Complex constant_gap = quotient(difference(product(a, rest), scaled(c, 2.0f)), gap);
    ComplexPair one = complex_quadratic(scaled(sum(a, gap), 0.5f), scaled(sum(rest, constant_gap), 0.5f));
    ComplexPair two =
        complex_quadratic(scaled(difference(a, gap), 0.5f), scaled(difference(rest, constant_gap), 0.5f));
    nodes.x[1] = one.first;
    nodes.x[2] = one.second;
    nodes.x[3] = two.first;
    nodes.x[4] = two.second;
#endif
    return nodes;
}

/// v_l of Eq. 6, from the order psi of the phases.
FN float textbook_value(IN(Complex) x, float query_order, IN(Basis) basis)
{
    float order = phase_order(x);
    float ramp = clamp(order * basis.ramp_scale + basis.ramp_offset, 0.0f, 1.0f);
    return order < query_order ? 1.0f : ramp;
}

/// A(z_f, b, beta) / b_0 as Algorithm 2 returns it, not clamped; NaN if the algorithm breaks down. moments: not normalised.
FN float textbook_fraction(IN(Moments) moments, float depth, float bias, float overestimation, IN(Basis) basis)
{
    CirclePolynomial b;
    b.q[0] = make_complex(1.0f, 0.0f);
    UNROLL
    for (int i = 0; i < MOMENT_COUNT; ++i)
    {
        float scale = (1.0f - bias) / moments.b0;
        b.q[i + 1] = make_complex(moments.b[2 * i] * scale, moments.b[2 * i + 1] * scale);
    }
    Complex half_x = half_phase(depth, basis);
    Complex x0 = product(half_x, half_x);
    CircleNodes nodes = nodes_of_circle_kernel(kernel_of_toeplitz(b, x0), x0);
    float query_order = phase_order(x0);
    Complex divided[ORDER];
    UNROLL
    for (int l = 0; l < ORDER; ++l)
        divided[l] = make_complex(l == 0 ? overestimation : textbook_value(nodes.x[l], query_order, basis), 0.0f);
    UNROLL
    for (int step = 1; step < ORDER; ++step)
    {
        UNROLL
        for (int l = ORDER - 1; l >= step; --l)
            divided[l] = quotient(difference(divided[l], divided[l - 1]), difference(nodes.x[l], nodes.x[l - step]));
    }
    Complex coefficient[ORDER];
    UNROLL
    for (int j = 0; j < ORDER; ++j) coefficient[j] = make_complex(0.0f, 0.0f);
    coefficient[0] = divided[ORDER - 1];
    UNROLL
    for (int l = ORDER - 2; l >= 0; --l)
    {
        UNROLL
        for (int j = ORDER - 1; j >= 0; --j)
            coefficient[j] = difference(choose_complex(j == 0, divided[l], coefficient[max(j - 1, 0)]),
                                        product(nodes.x[l], coefficient[j]));
    }
    float fraction = coefficient[0].re;
    UNROLL
    for (int j = 1; j < ORDER; ++j) fraction = fraction + product(coefficient[j], b.q[j]).re;
    return fraction;
}
