// canonical_masses.hpp -- the canonical representation on [-1, 1]: the distribution with the moments of a
// ray, a mass at a given depth and as few other masses as possible. The sharp bounds follow from it.
#pragma once
#include <optional>
#include <vector>

namespace momentscope {

/// A point mass.
struct DepthMass {
    long double depth;  // in [-1, 1]
    long double mass;
};

/// The recurrence of the orthonormal polynomials of a measure, as a symmetric tridiagonal matrix with n rows.
struct JacobiMatrix {
    std::vector<long double> diagonal;  // n entries
    std::vector<long double> beside;    // n entries below the diagonal; the last belongs to row n + 1
    long double total;                  // total mass of the measure
};

/// The canonical representations of one ray at all depths.
class CanonicalMasses {
public:
    /// degree n = 2, 3 or 4: the moments up to order 2n are used. The masses of the ray must sum to 1.
    /// nullopt if no other distribution on [-1, 1] has these moments.
    static std::optional<CanonicalMasses> of(const std::vector<DepthMass>& ray, int degree);

    /// Masses with the moments of the ray, in ascending order of depth. One of them lies at `depth` in [-1,
    /// 1]. Among all distributions on [-1, 1] with these moments, this one has the greatest mass at `depth`
    /// and the least in front of it and behind it (Chebyshev, Markov, Stieltjes; Krein and Nudelman 1977).
    /// The other masses are either n masses inside the range, or n - 1 inside and one at each end.
    std::vector<DepthMass> at(long double depth) const;

private:
    CanonicalMasses(JacobiMatrix free, JacobiMatrix between_ends, long double mean);

    JacobiMatrix free_;          // of the measure of the ray
    JacobiMatrix between_ends_;  // of the measure of the ray times 1 - z^2
    long double mean_;
};

}  // namespace momentscope
