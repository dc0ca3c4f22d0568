// steps.hpp -- Algorithm 1 or 2 at one query depth, step by step, with the numbers that the shared source
// computed on the way.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/inspect/canonical.hpp"
#include "core/inspect/curve.hpp"

namespace momentscope {

struct ComplexNumber {
    double re = 0, im = 0;
};

/// A Hankel, Toeplitz or Gram matrix of normalised moments, and how far it is from singular. All from the
/// floats of the shader, evaluated in double.
struct MomentMatrix {
    std::size_t order = 0;             // m/2 + 1, or m + 1 for trigonometric moments
    std::vector<ComplexNumber> entry;  // row by row; im is 0 but for Toeplitz matrices
    double smallest_eigenvalue = 0;
    double condition =
        0;  // greatest over smallest eigenvalue; infinite or negative when not positive definite
};

/// One node of the canonical representation.
struct StepNode {
    float t = 0;       // its place in the variable in which roots are found
    float depth = 0;   // beyond [-1, 1] where it lies outside the depth range
    double phase = 0;  // radians on the circle; trigonometric moments only
    float weight = 0;  // share of b0
    float value = 0;   // v_l: 1 in front, 0 behind, between in the wrapping zone
};

struct Steps {
    const Technique* technique = nullptr;
    ResolvedParameters parameters{};
    float query = 0;
    bool empty = true;           // no absorbance: nothing to reconstruct
    MomentVector stored;         // as the texture holds them
    MomentVector normalised;     // b / b0, unpacked
    MomentVector biased;         // after (1 - alpha) b + alpha b*
    MomentMatrix before, after;  // bias
    std::vector<float> pivots;   // h_k, norms of the orthogonal polynomials
    int floored_pivots = 0;
    std::vector<float> kernel;  // at_query, then the coefficients in t below the leading 1
    std::vector<StepNode> nodes;
    float query_weight = 0;  // w_0: the gap between the bounds over b0
    float in_front = 0;      // sum of w_l v_l
    float fraction = 0;      // plus beta w_0
    float absorbance = 0;    // times b0, clamped: what the second pass takes
    float transmittance = 1;
};

/// Of a curve's moments and parameters at a query depth in [-1, 1]. Empty for techniques without moments.
Steps reconstruction_steps(const Curve& curve, float query);

/// One step in words a student understands, with its equation and numbers.
struct StepText {
    std::string title;
    std::string sentence;
    std::string numbers;  // lines
};
std::vector<StepText> step_texts(const Steps& steps);

/// The same as text for the terminal.
std::string steps_to_text(const Steps& steps);

}  // namespace momentscope
