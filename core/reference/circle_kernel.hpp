// circle_kernel.hpp -- the kernel polynomial of Algorithm 2 as a real function of the angle from x0.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/reference/bracketed_root.hpp"
#include "core/reference/complex.hpp"
#include "core/reference/triangular_factor.hpp"

namespace momentscope::reference {

// An offset o in [0, 2 pi] from x0 is represented by its `place` p in [0, 2]. Take the half |x| + |y| = 1,
// y >= 0, of a diamond, and its point in the direction of o / 2: p is the length along the diamond to this
// point. It grows with o, and computing it takes a square root instead of a sine and a cosine.

/// exp(i o / 2) for the offset o of a place. Sets `scale` to d(o / 2) / dp.
template <class Real>
Complex<Real> half_of_place(const Real& place, Real& scale) {
    using std::abs;
    using std::sqrt;
    const Real x = Real(1) - place;
    const Complex<Real> on_diamond{x, Real(1) - abs(x)};
    scale = Real(1) / squared_modulus(on_diamond);
    return on_diamond * Real(sqrt(scale));
}

/// The place of the offset o with half = exp(i o / 2). half may also be the negative of this, if rounding or
/// a product moved it to the lower half plane.
template <class Real>
Real place_of_half(const Complex<Real>& half) {
    using std::abs;
    const Real y = abs(half.im);
    const Real x = half.im < Real(0) ? -half.re : half.re;
    return x >= Real(0) ? y / (x + y) : Real(1) - x / (y - x);
}

/// The place of an offset. Rounding may move offset / 2 slightly out of [0, pi]; it is then clamped, not
/// wrapped.
template <class Real>
Real place_of_offset(const Real& offset) {
    Complex<Real> half = unit<Real>(offset / Real(2));
    half.im = std::max(half.im, Real(0));
    return place_of_half(half);
}

/// K(x) = v(x0)^H G^-1 v(x) = sum conj(q_j) x^j at x = x0 exp(i o), times exp(-i degree o / 2). This is a
/// real function of o, because G is Toeplitz, and it is 1 / w0 > 0 at o = 0. So terms j and degree - j are
/// conjugate, and half of them are enough: the value is `middle` plus the real part of the sum of
/// pair[i] exp(i o / 2)^(degree - 2 i).
template <std::size_t M, class Real>
struct CircleKernel {
    std::array<Complex<Real>, M / 2 + 1> pair{};
    Real middle{};  // only for even degrees
    std::size_t degree = M;
    Real noise{};
    Real inverse_weight{};

    Sample<Real> operator()(const Real& place) const {
        Real scale;
        const Complex<Real> half = half_of_place(place, scale);
        const Complex<Real> whole = half * half;
        const bool even = degree % 2 == 0;
        Complex<Real> power = even ? whole : half;
        Sample<Real> at{middle, Real(0), noise};
        for (std::size_t exponent = even ? 2 : 1; exponent <= degree; exponent += 2) {
            const Complex<Real> term = pair[(degree - exponent) / 2] * power;
            at.value += term.re;
            at.slope -= term.im * static_cast<Real>(exponent);
            power = power * whole;
        }
        at.slope *= scale;
        return at;
    }
};

/// The kernel through x0 for the first `degree` moments. The text of the paper lost the conjugate of q_j.
/// Without it, the roots are those of another distribution, and weights are negative.
template <std::size_t M, class Real>
CircleKernel<M, Real> circle_kernel(const TriangularFactor<Real, Complex<Real>, M + 1>& toeplitz,
                                    const Complex<Real>& x0, std::size_t degree) {
    using std::abs;
    std::array<Complex<Real>, M + 1> v{};
    v[0].re = Real(1);
    for (std::size_t j = 1; j <= degree; ++j) v[j] = v[j - 1] * x0;
    const auto solution = solve(toeplitz, v, degree);
    CircleKernel<M, Real> kernel;
    kernel.degree = degree;
    kernel.inverse_weight = solution.inverse_weight;
    std::array<Complex<Real>, M + 1> coefficient{};  // conj(q_j) x0^j
    for (std::size_t j = 0; j <= degree; ++j) {
        coefficient[j] = conjugate(solution.q[j]) * v[j];
        kernel.noise += abs(coefficient[j].re) + abs(coefficient[j].im);
    }
    for (std::size_t i = 0; 2 * i < degree; ++i)
        kernel.pair[i] = coefficient[degree - i] + conjugate(coefficient[i]);
    if (degree % 2 == 0) kernel.middle = coefficient[degree / 2].re;
    kernel.noise *= std::numeric_limits<Real>::epsilon();
    return kernel;
}

}  // namespace momentscope::reference
