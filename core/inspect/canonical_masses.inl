// canonical_masses.inl -- the canonical representation in numbers of any precision. canonical_masses.cpp
// compiles it for the precision of the program, and tests for others.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/inspect/canonical_masses.hpp"

namespace momentscope {

namespace any_precision {

template <class Number>
using Vector = Eigen::Vector<Number, Eigen::Dynamic>;
template <class Number>
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

// If the norm of a polynomial falls below this share in one step, it is rounding noise: all masses lie at its
// zeros.
inline constexpr long double VANISHED = 1e-12L;

// A mass that lies at most this far beyond the depth range counts as a mass at its end.
inline constexpr long double AT_THE_END = 1e-9L;

// A mass that lies farther out than this counts as a mass at infinity.
inline constexpr long double FAR_AWAY = 1e6L;

// The Lanczos process. Vectors are made orthogonal again after each step. nullopt if there are too few
// masses.
template <class Number>
std::optional<JacobiMatrix<Number>> jacobi_matrix(const std::vector<DepthMassOf<Number>>& masses,
                                                  int degree) {
    using std::sqrt;
    const auto count = static_cast<Eigen::Index>(masses.size());
    Vector<Number> depths(count), roots(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        depths[i] = masses[static_cast<std::size_t>(i)].depth;
        roots[i] = sqrt(masses[static_cast<std::size_t>(i)].mass);
    }
    const Number norm = roots.norm();
    if (!(norm > 0)) return std::nullopt;
    JacobiMatrix<Number> result{{}, {}, norm * norm};
    std::vector<Vector<Number>> basis = {roots / norm};
    for (int k = 0; k < degree; ++k) {
        Vector<Number> next = depths.cwiseProduct(basis.back());
        result.diagonal.push_back(basis.back().dot(next));
        for (int pass = 0; pass < 2; ++pass)
            for (const Vector<Number>& one : basis) next -= one.dot(next) * one;
        result.beside.push_back(next.norm());
        if (result.beside.back() < VANISHED) return std::nullopt;
        basis.emplace_back(next / result.beside.back());
    }
    return result;
}

// Gauss-Radau quadrature (Golub 1973): n + 1 masses that have the moments of the measure, one of them at
// `depth`. Empty if one of the masses lies at infinity.
template <class Number>
std::vector<DepthMassOf<Number>> masses_with(const JacobiMatrix<Number>& matrix, const Number& depth) {
    using std::abs;
    const std::size_t n = matrix.diagonal.size();
    Number previous = 0, p = 1;  // p_k(depth), not normalised
    for (std::size_t k = 0; k < n; ++k) {
        const Number below = k == 0 ? 0 : matrix.beside[k - 1];
        const Number next = ((depth - matrix.diagonal[k]) * p - below * previous) / matrix.beside[k];
        previous = std::exchange(p, next);
    }
    const Number last = n == 0 ? depth : depth - matrix.beside[n - 1] * previous / p;
    if (!(abs(last) < FAR_AWAY)) return {};
    const auto size = static_cast<Eigen::Index>(n + 1);
    Matrix<Number> extended = Matrix<Number>::Zero(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const auto at = static_cast<std::size_t>(k);
        extended(k, k) = at < n ? matrix.diagonal[at] : last;
        if (at < n) extended(k + 1, k) = extended(k, k + 1) = matrix.beside[at];
    }
    const Eigen::SelfAdjointEigenSolver<Matrix<Number>> solver(extended);
    std::vector<DepthMassOf<Number>> masses;
    for (Eigen::Index k = 0; k < size; ++k) {
        const Number first = solver.eigenvectors()(0, k);
        masses.push_back({solver.eigenvalues()[k], matrix.total * first * first});
    }
    // By construction one of the masses lies at `depth`, up to rounding.
    std::ranges::min_element(masses, {}, [&](const auto& mass) { return abs(mass.depth - depth); })->depth =
        depth;
    return masses;
}

}  // namespace any_precision

template <class Number>
CanonicalMassesOf<Number>::CanonicalMassesOf(JacobiMatrix<Number> free, JacobiMatrix<Number> between_ends,
                                             Number mean)
    : free_(std::move(free)), between_ends_(std::move(between_ends)), mean_(mean) {}

template <class Number>
std::optional<CanonicalMassesOf<Number>> CanonicalMassesOf<Number>::of(const std::vector<Mass>& ray,
                                                                       int degree) {
    using std::abs;
    std::vector<Mass> inside;
    Number mean = 0;
    for (const Mass& one : ray) {
        if (abs(one.depth) < 1) inside.push_back({one.depth, one.mass * (1 - one.depth) * (1 + one.depth)});
        mean += one.mass * one.depth;
    }
    auto free = any_precision::jacobi_matrix(ray, degree);
    auto between_ends = any_precision::jacobi_matrix(inside, degree - 1);
    if (!free || !between_ends) return std::nullopt;
    return CanonicalMassesOf(std::move(*free), std::move(*between_ends), mean);
}

template <class Number>
auto CanonicalMassesOf<Number>::at(Number depth) const -> std::vector<Mass> {
    using std::abs;
    std::vector<Mass> masses = any_precision::masses_with(free_, depth);
    const bool are_inside = !masses.empty() && masses.front().depth >= -1 - any_precision::AT_THE_END &&
                            masses.back().depth <= 1 + any_precision::AT_THE_END;
    if (are_inside || abs(depth) >= 1) return masses;
    masses = any_precision::masses_with(between_ends_, depth);
    Number at_ends = 1, mean_of_ends = mean_;
    for (Mass& one : masses) {
        one.mass /= (1 - one.depth) * (1 + one.depth);
        at_ends -= one.mass;
        mean_of_ends -= one.mass * one.depth;
    }
    masses.insert(masses.begin(), {-1, 0.5L * (at_ends - mean_of_ends)});
    masses.push_back({1, 0.5L * (at_ends + mean_of_ends)});
    return masses;
}

}  // namespace momentscope
