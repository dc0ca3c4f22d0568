// canonical_masses.hpp -- the distribution that has the moments of a ray on the line, a mass at a given
// depth, and no more masses than it must have: what makes bounds sharp.
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
    std::vector<long double> beside;    // n: those of the diagonal below, and one beyond
    long double total;                  // mass
};

/// Of one ray, for any depth.
class CanonicalMasses {
public:
    /// degree n = 2, 3, 4: moments up to 2 n. The masses sum to 1. nullopt where the ray is the only
    /// distribution on [-1, 1] with its moments.
    static std::optional<CanonicalMasses> of(const std::vector<DepthMass>& ray, int degree);

    /// Masses with the ray's moments, ascending, one of them at `depth`. Of all distributions on [-1, 1] with
    /// these moments this one has the most at the depth and the least on either side of it (Chebyshev,
    /// Markov, Stieltjes; Krein and Nudelman 1977). Beside the depth it has n masses inside, or n - 1 and one
    /// at either end.
    std::vector<DepthMass> at(long double depth) const;

private:
    CanonicalMasses(JacobiMatrix free, JacobiMatrix between_ends, long double mean);

    JacobiMatrix free_;          // of the ray
    JacobiMatrix between_ends_;  // of the ray times 1 - z^2
    long double mean_;
};

}  // namespace momentscope
