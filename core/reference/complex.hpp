// complex.hpp -- the few complex operations that the references need, for any Real. std::complex is not used:
// its behaviour is unspecified for Boost numbers, and its product calls a library function to check for NaN.
#pragma once
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace momentscope::reference {

/// pi to the full precision of Real.
template <class Real>
Real pi() {
    return boost::math::constants::pi<Real>();
}

template <class Real>
struct Complex {
    Real re = Real(0);
    Real im = Real(0);
};

template <class Real>
Complex<Real> operator+(const Complex<Real>& a, const Complex<Real>& b) {
    return {a.re + b.re, a.im + b.im};
}
template <class Real>
Complex<Real> operator-(const Complex<Real>& a, const Complex<Real>& b) {
    return {a.re - b.re, a.im - b.im};
}
template <class Real>
Complex<Real> operator*(const Complex<Real>& a, const Complex<Real>& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class Real>
Complex<Real> operator*(const Complex<Real>& a, const Real& scale) {
    return {a.re * scale, a.im * scale};
}
template <class Real>
Complex<Real> operator/(const Complex<Real>& a, const Real& divisor) {
    return {a.re / divisor, a.im / divisor};
}

// The same functions for real and complex scalars, so that one factorisation serves Algorithms 1 and 2.
template <class Real>
Complex<Real> conjugate(const Complex<Real>& a) {
    return {a.re, -a.im};
}
template <class Real>
Real conjugate(const Real& a) {
    return a;
}
template <class Real>
Real real_part(const Complex<Real>& a) {
    return a.re;
}
template <class Real>
Real real_part(const Real& a) {
    return a;
}
template <class Real>
Real squared_modulus(const Complex<Real>& a) {
    return a.re * a.re + a.im * a.im;
}
template <class Real>
Real squared_modulus(const Real& a) {
    return a * a;
}

template <class Real>
Complex<Real> inverse(const Complex<Real>& a) {
    return conjugate(a) / squared_modulus(a);
}

/// exp(i angle).
template <class Real>
Complex<Real> unit(const Real& angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
}

}  // namespace momentscope::reference
