// steps.hpp -- the reconstruction at one query depth, step by step, with the intermediate results of the
// shared source.
#pragma once
#include <array>
#include <vector>

#include "core/inspect/canonical.hpp"
#include "core/inspect/curve.hpp"
#include "core/inspect/ray_ends.hpp"

namespace momentscope {

struct ComplexNumber {
    double re = 0, im = 0;
};

/// A Hankel, Toeplitz or Gram matrix of normalised moments, and how close it is to singular. Computed in
/// double from the floats of the shader.
struct MomentMatrix {
    std::size_t order = 0;             // m/2 + 1, or m + 1 for trigonometric moments
    std::vector<ComplexNumber> entry;  // row by row; im is 0 except in Toeplitz matrices
    double smallest_eigenvalue = 0;
    double condition = 0;  // greatest over smallest eigenvalue; infinite or negative if not positive definite
};

/// One node of the canonical representation.
struct StepNode {
    float t = 0;       // its place in the variable of the roots
    float depth = 0;   // may lie outside of [-1, 1], the depth range
    double phase = 0;  // in radians; only on the circle
    float weight = 0;  // share of b0
    float value = 0;   // v_l: 1 in front, 0 behind; in between in the wrapping zone
};

struct Steps {
    const Technique* technique = nullptr;
    ResolvedParameters parameters{};
    float query = 0;
    bool empty = true;           // no absorbance, nothing to reconstruct
    MomentVector stored;         // as stored in the texture
    MomentVector normalised;     // b / b0, unpacked
    MomentVector biased;         // after (1 - alpha) b + alpha b*
    MomentMatrix before, after;  // bias: the matrix before and after it
    std::vector<float> pivots;   // h_k, norms of the orthogonal polynomials
    int floored_pivots = 0;
    std::vector<float> kernel;  // at_query, then the coefficients in t below the leading 1
    std::vector<StepNode> nodes;
    float query_weight = 0;     // w_0: the gap between the bounds, divided by b0
    float in_front = 0;         // sum of w_l v_l
    float fraction = 0;         // in_front + beta w_0
    float own = 0;              // absorbance of the fragment at the query, taken out of w_0; 0: no fragment
    RayEnd end = RayEnd::none;  // the end whose step holds this fragment
    float absorbance = 0;       // by the estimate of the parameters
    float transmittance = 1;
    bool with_ends = false;      // both ends of the ray are nodes, because a root lies beyond one of them
    float lower = 0, upper = 0;  // the bounds between which A is estimated; only unless published
};

/// The steps for the moments and parameters of a curve, at a query depth in [-1, 1]. Empty for techniques
/// without moments. fragment: the one that asks, at the query depth; nullptr: none does. The published
/// techniques do not tell these two apart.
Steps reconstruction_steps(const Curve& curve, float query, const Fragment* fragment = nullptr);

/// The fragment of a ray at this depth; nullptr if there is none. If several lie there, the first.
const Fragment* fragment_at(const ViewRay& ray, float depth);

}  // namespace momentscope
