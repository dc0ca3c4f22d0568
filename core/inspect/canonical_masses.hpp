// canonical_masses.hpp -- the canonical representation on [-1, 1]: the distribution with the moments of a
// ray, a mass at a given depth and as few other masses as possible. The sharp bounds follow from it.
#pragma once
#include <optional>
#include <vector>

#include "core/reference/extended.hpp"

namespace momentscope {

/// A point mass.
template <class Number>
struct DepthMassOf {
    Number depth;  // in [-1, 1]
    Number mass;
};

/// The recurrence of the orthonormal polynomials of a measure, as a symmetric tridiagonal matrix with n rows.
template <class Number>
struct JacobiMatrix {
    std::vector<Number> diagonal;  // n entries
    std::vector<Number> beside;    // n entries below the diagonal; the last belongs to row n + 1
    Number total;                  // total mass of the measure
};

/// The canonical representations of one ray at all depths.
template <class Number>
class CanonicalMassesOf {
public:
    using Mass = DepthMassOf<Number>;

    /// degree n = 2, 3 or 4: the moments up to order 2n are used. The masses of the ray must sum to 1.
    /// nullopt if no other distribution on [-1, 1] has these moments.
    static std::optional<CanonicalMassesOf> of(const std::vector<Mass>& ray, int degree);

    /// Masses with the moments of the ray, in ascending order of depth. One of them lies at `depth` in [-1,
    /// 1]. Among all distributions on [-1, 1] with these moments, this one has the greatest mass at `depth`
    /// and the least in front of it and behind it (Chebyshev, Markov, Stieltjes; Krein and Nudelman 1977).
    /// The other masses are either n masses inside the range, or n - 1 inside and one at each end.
    std::vector<Mass> at(Number depth) const;

private:
    CanonicalMassesOf(JacobiMatrix<Number> free, JacobiMatrix<Number> between_ends, Number mean);

    JacobiMatrix<Number> free_;          // of the measure of the ray
    JacobiMatrix<Number> between_ends_;  // of the measure of the ray times 1 - z^2
    Number mean_;
};

using DepthMass = DepthMassOf<reference::Extended>;
using CanonicalMasses = CanonicalMassesOf<reference::Extended>;

}  // namespace momentscope
