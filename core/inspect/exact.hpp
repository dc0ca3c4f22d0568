// exact.hpp -- what a technique would compute if arithmetic were exact, through core/reference, which shares
// no code with shaders/: the judge of tests and of `stress`, and the window's curve without bias.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

using Real = long double;

/// Fractions of b0: in front of a depth for beta = 0, and the mass w_0 at the depth.
struct ExactFraction {
    Real in_front = 0;
    Real query_weight = 0;
    Real with(float beta) const { return in_front + static_cast<Real>(beta) * query_weight; }
};
using ExactFunction = std::function<ExactFraction(Real depth)>;

/// From the exact moments of a ray with the parameters' theta and alpha. nullopt where the biased matrix of
/// moments is not positive definite, so that there is no such function, without fragments, and for bases that
/// core/reference does not have.
std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters);

/// The same from moments as they are stored, with all their rounding.
std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters);

/// A(z, b, beta) of an exact function at `depths`, in [0, b0], b0 being that of the ray. Without one because
/// the matrix is singular, moments leave one distribution alone: the truth, with beta of a mass at the depth
/// itself.
std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths);

/// A(z, b, beta) at `depths` in [-1, 1] from exact moments without bias. Where so few fragments lie on the
/// ray that their moments leave no other distribution (Section 4.1), this is the truth, plus beta of the mass
/// at the depth itself. Empty for techniques without moments and for bases that core/reference does not have.
std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths);

}  // namespace momentscope
