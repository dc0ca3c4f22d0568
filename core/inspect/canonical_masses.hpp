// canonical_masses.hpp -- the canonical representation on [-1, 1]: the distribution with the moments of a
// ray, a mass at a given depth and as few other masses as possible. It gives the sharp bounds.
#pragma once
#include <optional>
#include <vector>

namespace momentscope {

/// A point mass.
struct DepthMass {
    long double depth;  // [-1, 1]
    long double mass;
};

/// The recurrence of the orthonormal polynomials of a measure, as a symmetric tridiagonal matrix.
struct JacobiMatrix {
    std::vector<long double> diagonal;  // n
    std::vector<long double> beside;    // n: of the first lower diagonal; the last belongs to the next row
    long double total;                  // mass of the measure
};

/// The canonical representations of one ray.
class CanonicalMasses {
public:
    /// degree n = 2, 3, 4: moments up to 2 n. The masses sum to 1. nullopt if no other distribution
    /// on [-1, 1] has the ray's moments.
    static std::optional<CanonicalMasses> of(const std::vector<DepthMass>& ray, int degree);

    /// Masses with the ray's moments, in ascending order, one of them at `depth` in [-1, 1]. Among all
    /// distributions on [-1, 1] with these moments, this one has the greatest mass at the depth and the least
    /// in front of it and behind it (Chebyshev, Markov, Stieltjes; Krein and Nudelman 1977). The other masses
    /// are n inside the range, or n - 1 inside and one at each end.
    std::vector<DepthMass> at(long double depth) const;

private:
    CanonicalMasses(JacobiMatrix free, JacobiMatrix between_ends, long double mean);

    JacobiMatrix free_;          // of the ray
    JacobiMatrix between_ends_;  // of the ray times 1 - z^2
    long double mean_;
};

}  // namespace momentscope
