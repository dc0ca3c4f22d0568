#include "core/inspect/canonical_masses.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace momentscope {

namespace {

using Vector = Eigen::Vector<long double, Eigen::Dynamic>;
using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// If the norm of a polynomial falls below this share in one step, it is rounding noise: all masses lie at its
// zeros.
constexpr long double VANISHED = 1e-12L;

// A mass that lies at most this far beyond the depth range counts as a mass at its end.
constexpr long double AT_THE_END = 1e-9L;

// A mass that lies farther out than this counts as a mass at infinity.
constexpr long double FAR_AWAY = 1e6L;

// The Lanczos process. Vectors are made orthogonal again after each step. nullopt if there are too few
// masses.
std::optional<JacobiMatrix> jacobi_matrix(const std::vector<DepthMass>& masses, int degree) {
    const auto count = static_cast<Eigen::Index>(masses.size());
    Vector depths(count), roots(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        depths[i] = masses[static_cast<std::size_t>(i)].depth;
        roots[i] = std::sqrt(masses[static_cast<std::size_t>(i)].mass);
    }
    const long double norm = roots.norm();
    if (!(norm > 0)) return std::nullopt;
    JacobiMatrix result{{}, {}, norm * norm};
    std::vector<Vector> basis = {roots / norm};
    for (int k = 0; k < degree; ++k) {
        Vector next = depths.cwiseProduct(basis.back());
        result.diagonal.push_back(basis.back().dot(next));
        for (int pass = 0; pass < 2; ++pass)
            for (const Vector& one : basis) next -= one.dot(next) * one;
        result.beside.push_back(next.norm());
        if (result.beside.back() < VANISHED) return std::nullopt;
        basis.emplace_back(next / result.beside.back());
    }
    return result;
}

// Gauss-Radau quadrature (Golub 1973): n + 1 masses that have the moments of the measure, one of them at
// `depth`. Empty if one of the masses lies at infinity.
std::vector<DepthMass> masses_with(const JacobiMatrix& matrix, long double depth) {
    const std::size_t n = matrix.diagonal.size();
    long double previous = 0, p = 1;  // p_k(depth), not normalised
    for (std::size_t k = 0; k < n; ++k) {
        const long double below = k == 0 ? 0 : matrix.beside[k - 1];
        const long double next = ((depth - matrix.diagonal[k]) * p - below * previous) / matrix.beside[k];
        previous = std::exchange(p, next);
    }
    const long double last = n == 0 ? depth : depth - matrix.beside[n - 1] * previous / p;
    if (!(std::abs(last) < FAR_AWAY)) return {};
    const auto size = static_cast<Eigen::Index>(n + 1);
    Matrix extended = Matrix::Zero(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const auto at = static_cast<std::size_t>(k);
        extended(k, k) = at < n ? matrix.diagonal[at] : last;
        if (at < n) extended(k + 1, k) = extended(k, k + 1) = matrix.beside[at];
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(extended);
    std::vector<DepthMass> masses;
    for (Eigen::Index k = 0; k < size; ++k) {
        const long double first = solver.eigenvectors()(0, k);
        masses.push_back({solver.eigenvalues()[k], matrix.total * first * first});
    }
    // By construction one of the masses lies at `depth`, up to rounding.
    std::ranges::min_element(masses, {}, [&](const DepthMass& mass) {
        return std::abs(mass.depth - depth);
    })->depth = depth;
    return masses;
}

}  // namespace

CanonicalMasses::CanonicalMasses(JacobiMatrix free, JacobiMatrix between_ends, long double mean)
    : free_(std::move(free)), between_ends_(std::move(between_ends)), mean_(mean) {}

std::optional<CanonicalMasses> CanonicalMasses::of(const std::vector<DepthMass>& ray, int degree) {
    std::vector<DepthMass> inside;
    long double mean = 0;
    for (const DepthMass& one : ray) {
        if (std::abs(one.depth) < 1)
            inside.push_back({one.depth, one.mass * (1 - one.depth) * (1 + one.depth)});
        mean += one.mass * one.depth;
    }
    auto free = jacobi_matrix(ray, degree);
    auto between_ends = jacobi_matrix(inside, degree - 1);
    if (!free || !between_ends) return std::nullopt;
    return CanonicalMasses(std::move(*free), std::move(*between_ends), mean);
}

std::vector<DepthMass> CanonicalMasses::at(long double depth) const {
    std::vector<DepthMass> masses = masses_with(free_, depth);
    const bool are_inside =
        !masses.empty() && masses.front().depth >= -1 - AT_THE_END && masses.back().depth <= 1 + AT_THE_END;
    if (are_inside || std::abs(depth) >= 1) return masses;
    masses = masses_with(between_ends_, depth);
    long double at_ends = 1, mean_of_ends = mean_;
    for (DepthMass& one : masses) {
        one.mass /= (1 - one.depth) * (1 + one.depth);
        at_ends -= one.mass;
        mean_of_ends -= one.mass * one.depth;
    }
    masses.insert(masses.begin(), {-1, 0.5L * (at_ends - mean_of_ends)});
    masses.push_back({1, 0.5L * (at_ends + mean_of_ends)});
    return masses;
}

}  // namespace momentscope
