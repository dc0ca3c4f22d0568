// moment_kernel.hpp -- one moment-based technique as C++ functions: what shaders/shared says, compiled for
// the CPU.
#pragma once
#include <array>
#include <span>

#include "core/parameter_choices.hpp"

namespace momentscope {

constexpr int MAX_MOMENT_FLOATS = 8;
constexpr int MAX_BASIS_FLOATS = 8;
constexpr int MAX_NODES = 4;  // of the canonical representation, beside the query depth

/// What a pixel stores: the total absorbance b0 >= 0 and, in 32 bits, its other real moments, not normalised;
/// in 16 bits normalised and transformed into [0, 1], multiples of 1/65535, and b0 rounded to a half float.
struct MomentVector {
    float b0 = 0;
    std::array<float, MAX_MOMENT_FLOATS> b{};  // the first MomentKernel::moment_floats count
};

struct ReconstructionSettings {
    float overestimation = 0.25f;    // beta in [0, 1]
    float wrapping_zone_angle = 0;   // theta in [0, pi]; trigonometric moments only
    float tolerance = 0;             // epsilon of nested orders, which choose their own
    float bias = 0;                  // moment bias alpha in [0, 1]
    Solver solver = Solver::robust;  // textbook: Algorithms 1 and 2 as published
};

/// Absorbances per depth, all in [0, b0]; the spans are as long as the depths.
struct AbsorbanceCurves {
    std::span<float> reconstructed;
    std::span<float> beta0;  // for power moments the lower bound
    std::span<float> beta1;  // for power moments the upper bound
};

/// One way from moments to the absorbance at a single depth, with the numbers in between, by the robust
/// solver.
struct ReconstructionSteps {
    MomentVector biased;                        // normalised, b0 = 1
    std::array<float, MAX_NODES + 1> pivots{};  // h_k, normalised
    int floored_pivots = 0;
    float query_weight = 0;                     // w_0
    std::array<float, MAX_NODES + 1> kernel{};  // at_query, then the monic coefficients in t
    std::array<float, MAX_NODES> t{}, weight{}, value{};
    float in_front = 0;  // fraction of b0 for beta = 0, before it is clamped
    float fraction = 0;  // of b0 in front for the settings' beta, before it is clamped
    float absorbance = 0;
};

/// The functions of one technique. moments of a b0 below MIN_ABSORBANCE reconstruct to absorbance 0.
struct MomentKernel {
    int moment_floats;
    int node_count;
    int factor_floats;  // numbers that the factor of a pixel's matrix takes
    int bits;           // per stored number, 32 or 16
    bool has_textbook;  // is there an Algorithm 1 or 2 for it? Else settings ask for Solver::robust

    /// What depends on theta, or on the tolerance of nested orders, but not on depth: the shared source's
    /// StoredBasis, then zeros.
    std::array<float, MAX_BASIS_FLOATS> (*basis)(float parameter);

    /// Adds a fragment at depth [-1, 1] as the first pass does: in 32 bits one float addition per moment, in
    /// 16 bits with all roundings.
    void (*add_fragment)(MomentVector& stored, float depth, float absorbance, float wrapping_zone_angle);

    /// The moments that stored numbers stand for, not normalised. All other functions take stored numbers.
    MomentVector (*moments_of)(const MomentVector& stored);

    /// Curves over many depths in [-1, 1]; factors once, then runs as wide as the CPU allows.
    void (*evaluate)(const MomentVector& moments, const ReconstructionSettings& settings,
                     std::span<const float> depths, const AbsorbanceCurves& curves);

    /// A(z_f, b, beta) / b0 by the settings' solver before it is clamped to [0, 1]; the textbook's may be
    /// NaN. 0 for empty moments.
    float (*fraction)(const MomentVector& moments, const ReconstructionSettings& settings, float depth);

    /// The same for many pixels, each at one depth: fractions[i] of moments[i] at depths[i], in the same
    /// bits. Biases and factors each, and runs as wide as the CPU allows (the textbook goes one by
    /// one): the way to use a kernel where there are many queries.
    void (*fractions)(std::span<const MomentVector> moments, const ReconstructionSettings& settings,
                      std::span<const float> depths, std::span<float> fractions);

    ReconstructionSteps (*steps)(const MomentVector& moments, const ReconstructionSettings& settings,
                                 float depth);
};

}  // namespace momentscope
