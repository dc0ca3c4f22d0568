// triangular_factor.hpp -- the inverse of a Hermitian positive definite moment matrix as L^-H D^-1 L^-1.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/reference/complex.hpp"

namespace momentscope::reference {

template <class Scalar, std::size_t Size>
using SquareMatrix = std::array<std::array<Scalar, Size>, Size>;

/// The factor of G = L D L^H. `inverse` is L^-1, which is unit lower triangular. `pivot` is the diagonal of
/// D, whose entries are positive. Row k of `inverse` holds the coefficients of the k-th monic orthogonal
/// polynomial; pivot[k] is its squared norm.
template <class Real, class Scalar, std::size_t Size>
struct TriangularFactor {
    SquareMatrix<Scalar, Size> inverse{};
    std::array<Real, Size> pivot{};
};

/// Computes L of G = L D L^H below its unit diagonal, and D. False if a pivot is not positive to working
/// precision. The error of pivot k is about epsilon G_kk, so a value below a few times this does not even
/// tell its sign.
template <class Real, class Scalar, std::size_t Size>
bool decompose(const SquareMatrix<Scalar, Size>& matrix, SquareMatrix<Scalar, Size>& lower,
               std::array<Real, Size>& pivot) {
    const Real floor = Real(16) * std::numeric_limits<Real>::epsilon();
    for (std::size_t row = 0; row < Size; ++row) {
        Real rest = real_part(matrix[row][row]);
        for (std::size_t column = 0; column < row; ++column) {
            Scalar sum = matrix[row][column];
            for (std::size_t k = 0; k < column; ++k)
                sum = sum - lower[row][k] * conjugate(lower[column][k]) * pivot[k];
            lower[row][column] = sum / pivot[column];
            rest -= squared_modulus(lower[row][column]) * pivot[column];
        }
        pivot[row] = rest;
        if (!(rest > floor * real_part(matrix[row][row]))) return false;  // also false for NaN
    }
    return true;
}

/// The factor of a Hermitian matrix. nullopt if the matrix is not positive definite to working precision.
template <class Real, class Scalar, std::size_t Size>
std::optional<TriangularFactor<Real, Scalar, Size>> triangular_factor(
    const SquareMatrix<Scalar, Size>& matrix) {
    SquareMatrix<Scalar, Size> lower{};
    TriangularFactor<Real, Scalar, Size> factor;
    if (!decompose(matrix, lower, factor.pivot)) return std::nullopt;
    for (std::size_t column = 0; column < Size; ++column) {
        factor.inverse[column][column] = Scalar{Real(1)};
        for (std::size_t row = column + 1; row < Size; ++row)
            for (std::size_t k = column; k < row; ++k)
                factor.inverse[row][column] =
                    factor.inverse[row][column] - lower[row][k] * factor.inverse[k][column];
    }
    return factor;
}

/// The solution q of G q = v for the leading (degree + 1) rows and columns, and
/// `inverse_weight` = v^H G^-1 v = 1 / w0.
template <class Real, class Scalar, std::size_t Size>
struct KernelSolution {
    std::array<Scalar, Size> q{};
    Real inverse_weight = Real(0);
};

/// Solves G q = v, the linear system of Algorithms 1 and 2, with the factor of G. degree < Size.
template <class Real, class Scalar, std::size_t Size>
KernelSolution<Real, Scalar, Size> solve(const TriangularFactor<Real, Scalar, Size>& factor,
                                         const std::array<Scalar, Size>& v, std::size_t degree) {
    KernelSolution<Real, Scalar, Size> solution;
    for (std::size_t row = 0; row <= degree; ++row) {
        Scalar c = v[0] * factor.inverse[row][0];
        for (std::size_t k = 1; k <= row; ++k) c = c + factor.inverse[row][k] * v[k];
        const Scalar scaled = c / factor.pivot[row];
        solution.inverse_weight += squared_modulus(c) / factor.pivot[row];
        for (std::size_t k = 0; k <= row; ++k)
            solution.q[k] = solution.q[k] + conjugate(factor.inverse[row][k]) * scaled;
    }
    return solution;
}

}  // namespace momentscope::reference
