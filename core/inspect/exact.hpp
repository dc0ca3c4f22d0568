// exact.hpp -- what a technique would compute in exact arithmetic. It uses core/reference, which shares no
// code with shaders/. Tests and `stress` compare with it, and the window draws it as the unbiased exact
// curve.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

using Real = long double;

/// Fractions of b0: the fraction in front of a depth for beta = 0, and the mass w_0 at the depth.
struct ExactFraction {
    Real in_front = 0;
    Real query_weight = 0;
    Real with(float beta) const { return in_front + static_cast<Real>(beta) * query_weight; }
};
using ExactFunction = std::function<ExactFraction(Real depth)>;

/// The function for the exact moments of a ray, with theta and alpha of the parameters. nullopt if the biased
/// matrix of moments is not positive definite, because there is no such function then. Also nullopt without
/// fragments, and for bases that core/reference does not have.
std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters);

/// The same for moments as stored, with all their rounding.
std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters);

/// A(z, b, beta) of an exact function at `depths`, in [0, b0], where b0 is that of the ray. Without a
/// function, the matrix is singular and the moments determine the distribution. Then this is the truth, plus
/// beta times the mass at the depth itself.
std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths);

/// The unbiased exact curve: A(z, b, beta) at `depths` in [-1, 1] from exact moments without bias. If the ray
/// has so few fragments that the moments determine the distribution (paper, Section 4.1), this is the truth,
/// plus beta times the mass at the depth itself. Empty for techniques without moments and for bases that
/// core/reference does not have.
std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths);

}  // namespace momentscope
