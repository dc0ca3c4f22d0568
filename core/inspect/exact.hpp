// exact.hpp -- what a technique would compute in exact arithmetic, here with at least 64 bits
// (core/reference/extended.hpp). It uses core/reference, which shares no code with shaders/. Tests and
// `stress` compare with it, and the window draws it as the unbiased exact curve.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "core/inspect/curve.hpp"
#include "core/reference/extended.hpp"

namespace momentscope {

/// Two fractions of b0 at one depth. in_front: the fraction in front of it for beta = 0. query_weight: the
/// mass w_0 at the depth itself.
template <class Number>
struct ExactFractionOf {
    Number in_front = 0;
    Number query_weight = 0;
    Number with(float beta) const { return in_front + static_cast<Number>(beta) * query_weight; }
};
template <class Number>
using ExactFunctionOf = std::function<ExactFractionOf<Number>(Number depth)>;

using Real = reference::Extended;
using ExactFraction = ExactFractionOf<Real>;
using ExactFunction = ExactFunctionOf<Real>;

/// The exact function for the moments of a ray. It reads theta, alpha and the tolerance of the parameters,
/// but not beta. nullopt if the biased matrix of moments is not positive definite, because no such function
/// exists then. Also nullopt if no fragment has an opacity above 0, for techniques without moments, and for
/// bases that core/reference does not have.
std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters);

/// The same, but from the moments as a pixel stores them, which were already rounded.
std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters);

/// The absorbance in front of each of the depths, from an exact function; in [0, b0], where b0 is the total
/// absorbance of the ray. If `exact` is nullopt, the result is the truth, plus beta times the mass at the
/// depth itself. This is right if the matrix is singular, because the moments then determine the
/// distribution.
std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths);

}  // namespace momentscope
