// moment_kernel.hpp -- one technique with moments as C++ functions: shaders/shared, compiled for the CPU.
#pragma once
#include <array>
#include <span>

#include "core/parameters/parameter_choices.hpp"

namespace momentscope {

constexpr int MAX_MOMENT_FLOATS = 8;
constexpr int MAX_BASIS_FLOATS = 8;
constexpr int MAX_NODES = 4;  // of the canonical representation, without the query depth

/// What a pixel stores: the total absorbance b0 >= 0 and the other moments as real numbers. In 32 bits they
/// are not normalised. In 16 bits they are normalised and transformed into [0, 1], as multiples of 1/65535,
/// and b0 is rounded to a half float.
///
/// The ends of the ray are whole numbers of steps (shaders/shared/ends.glsl). They are 0 unless the ends are
/// known.
struct MomentVector {
    float b0 = 0;
    std::array<float, MAX_MOMENT_FLOATS> b{};  // MomentKernel::moment_floats of them are used
    float near_step = 0, far_step = 0;
};

/// What is known of the transmittance to a fragment (shaders/shared/fragment_estimate.glsl).
struct FragmentEstimate {
    float lower = 0, upper = 0;  // the absorbance in front lies between these
    float transmittance = 1;
    float spread = 0;  // how far T may be moved by a renormalisation of what is uncertain
};

struct ReconstructionSettings {
    float overestimation = 0.25f;    // beta, in [0, 1]
    float wrapping_zone_angle = 0;   // theta, in [0, pi]; only for trigonometric moments
    float tolerance = 0;             // epsilon; only for nested orders
    float bias = 0;                  // moment bias alpha, in [0, 1]
    Solver solver = Solver::robust;  // textbook: Algorithms 1 and 2 as published
    Estimate estimate = Estimate::beta;
    RayEnds ends = RayEnds::off;
    MomentInterval interval = MomentInterval::scene;
};

/// Absorbances at some depths, all in [0, b0]. The spans are as long as the list of depths.
struct AbsorbanceCurves {
    std::span<float> reconstructed;
    std::span<float> beta0;  // beta = 0: the lower bound on the line
    std::span<float> beta1;  // beta = 1: the upper bound on the line
};

/// One reconstruction of the absorbance at a single depth by the robust solver, with all intermediate
/// results.
struct ReconstructionSteps {
    MomentVector biased;                        // normalised, b0 = 1
    std::array<float, MAX_NODES + 1> pivots{};  // h_k, normalised
    int floored_pivots = 0;
    float query_weight = 0;                     // w_0
    std::array<float, MAX_NODES + 1> kernel{};  // at_query, then the monic coefficients in t
    std::array<float, MAX_NODES> t{}, weight{}, value{};
    float in_front = 0;    // fraction of b0 in front for beta = 0, not clamped
    float fraction = 0;    // fraction of b0 in front for the beta of the settings, not clamped
    float absorbance = 0;  // that fraction of b0, clamped

    // With moments of the pixel's own interval and sharp bounds there is a second representation, which has
    // both ends as nodes. It takes the place of the first if nodes of the first lie beyond an end. Then
    // node_count - 1 of t, weight and value are used.
    bool with_ends = false;
    float depth = 0;  // the query in the interval of the moments, in [-1, 1]
    float near_weight = 0, far_weight = 0;
};

/// The functions of one technique. Moments with a b0 below MIN_ABSORBANCE reconstruct to an absorbance of 0.
struct MomentKernel {
    int moment_floats;
    int node_count;
    int factor_floats;  // numbers in the factor of a pixel
    int inner_floats;   // further ones for sharp bounds in the pixel's own interval; 0 if there are none
    int bits;           // bits per stored number: 32 or 16
    bool has_textbook;  // is there an Algorithm 1 or 2? If not, use Solver::robust

    /// The numbers that depend on theta, or on the tolerance of nested orders, but not on depth: the
    /// StoredBasis of the shared source, then zeros.
    std::array<float, MAX_BASIS_FLOATS> (*basis)(float parameter);

    /// Adds a fragment as the first pass does. depth in [-1, 1]. In 32 bits this is one float addition per
    /// moment; in 16 bits it includes all roundings. With settings.interval == pixel the ends must be known.
    void (*add_fragment)(MomentVector& stored, float depth, float absorbance,
                         const ReconstructionSettings& settings);

    /// Moves the ends of the ray as the first pass, or the pass before it, does. depth in [-1, 1].
    void (*add_ends)(MomentVector& stored, float depth, float absorbance);

    /// A depth in the interval that moments are taken of, in [-1, 1].
    float (*moment_depth)(const MomentVector& stored, float depth, const ReconstructionSettings& settings);

    /// The moments that the stored numbers represent, not normalised. All other functions take stored
    /// numbers.
    MomentVector (*moments_of)(const MomentVector& stored);

    /// Curves at many depths in [-1, 1], for queries that do not belong to a fragment. Factors once, then
    /// runs in vectors as wide as the CPU allows. Depths beyond the ends of the ray have the absorbance 0 or
    /// b0.
    void (*evaluate)(const MomentVector& moments, const ReconstructionSettings& settings,
                     std::span<const float> depths, const AbsorbanceCurves& curves);

    /// A(z_f, b, beta) / b0 by the solver of the settings, not clamped to [0, 1] yet. The textbook solver may
    /// return NaN. 0 for empty moments.
    float (*fraction)(const MomentVector& moments, const ReconstructionSettings& settings, float depth);

    /// The same for many pixels with one depth each: fractions[i] is that of moments[i] at depths[i], with
    /// the same bits. Biases and factors every pixel, and runs in vectors as wide as the CPU allows, except
    /// for the textbook solver. Prefer it if there are many queries.
    void (*fractions)(std::span<const MomentVector> moments, const ReconstructionSettings& settings,
                      std::span<const float> depths, std::span<float> fractions);

    /// What the second pass computes for fragments of one pixel. depths in [-1, 1]; own: the absorbances of
    /// the fragments. The spans have one length.
    void (*estimates)(const MomentVector& moments, const ReconstructionSettings& settings,
                      std::span<const float> depths, std::span<const float> own,
                      std::span<FragmentEstimate> estimates);

    /// All steps of the robust solver at one depth in [-1, 1].
    ReconstructionSteps (*steps)(const MomentVector& moments, const ReconstructionSettings& settings,
                                 float depth);
};

}  // namespace momentscope
