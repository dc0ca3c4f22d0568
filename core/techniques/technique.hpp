// technique.hpp -- the registry of techniques.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/parameters/parameters.hpp"
#include "core/techniques/basis.hpp"
#include "core/techniques/pixel_state_kernel.hpp"

namespace momentscope {

struct MomentKernel;
struct ReconstructionSettings;

/// How the transmittance to a fragment follows from moments (docs/less_error.md).
struct Estimation {
    Estimate estimate = Estimate::beta;
    RayEnds ends = RayEnds::off;
    MomentInterval interval = MomentInterval::scene;
    Renormalization renormalization = Renormalization::uniform;
};

/// A technique that stores moments of the absorbance and reconstructs the transmittance from them.
struct MomentMath {
    const MomentKernel* kernel;                 // its functions in C++, of moments and depths; never null
    const Basis* basis;                         // never null
    int moment_count;                           // m
    float recommended_bias;                     // alpha = auto with the preset table1
    float robust_bias;                          // alpha = auto with the preset robust (docs/bias.md)
    std::optional<Estimation> estimation = {};  // of its own; nullopt if parameters choose it
};

/// A technique that stores other numbers than moments.
struct PixelStateMath {
    const PixelStateKernel* kernel;         // never null
    const char* math_file;                  // shaders/shared/<math_file>.glsl
    int (*floats)(const ParameterValues&);  // numbers per pixel
    int (*bits)(const ParameterValues&);    // bits per pixel, as in the published technique
};

/// The exact picture, whatever it costs.
struct GroundTruth {
    enum class Way { sorting, peeling } way;
    int bits = 0;  // per pixel; 0 if they grow with the number of fragments
};

/// One row of the registry: everything that the program says about a technique.
struct Technique {
    const char* id;
    const char* name;
    const char* description;  // a short paragraph
    const char* source;       // paper, section, algorithm
    std::variant<MomentMath, PixelStateMath, GroundTruth> math;
    std::vector<ParameterId> parameters = {};  // parameters that it reads
    int geometry_passes = 1;                   // of the transparent geometry; 0: one per layer
    bool order_dependent = false;              // does the order of submission change the picture?

    bool uses(ParameterId parameter_id) const;

    bool has_moments() const { return std::holds_alternative<MomentMath>(math); }
    bool has_pixel_states() const { return std::holds_alternative<PixelStateMath>(math); }
    bool is_truth() const { return std::holds_alternative<GroundTruth>(math); }

    // Each of these throws std::bad_variant_access if the technique is of another kind.
    const MomentMath& moments() const { return std::get<MomentMath>(math); }
    const MomentKernel& moment_kernel() const { return *moments().kernel; }
    const PixelStateMath& pixel_states() const { return std::get<PixelStateMath>(math); }
    const PixelStateKernel& pixel_state_kernel() const { return *pixel_states().kernel; }
    const GroundTruth& truth() const { return std::get<GroundTruth>(math); }

    // False for techniques without moments.
    bool on_circle() const { return has_moments() && moments().basis->on_circle(); }
    // Are the results for beta = 0 and beta = 1 bounds for all distributions with the biased moments?
    bool has_bounds() const { return has_moments() && moments().basis->has_bounds(); }
    bool is_of(BasisFamily family) const { return has_moments() && moments().basis->family == family; }
};

/// All techniques, in the order of listings. Their ids are unique.
std::span<const Technique> techniques();
std::vector<const Technique*> moment_based_techniques();  // techniques with moments
const Technique* find_technique(std::string_view id);     // nullptr if there is none

/// The technique with this id. Throws Error, with a list of all ids, if there is none.
const Technique& require_technique(std::string_view id);

/// The least wrapping zone, in radians: about 1/126 of the circle. Without a zone, depths -1 and 1 are the
/// same point, and rounding alone decides at which of them a surface lies (docs/stability.md).
constexpr float MIN_WRAPPING_ZONE = 0.05f;

/// The values that a technique computes with. `auto` is replaced by a recommendation, and theta is at least
/// MIN_WRAPPING_ZONE.
struct ResolvedParameters {
    float beta = 0, theta = 0, alpha = 0;
    bool textbook = false;       // solver: Algorithm 1 or 2 as published
    bool factored_once = false;  // moments are factored once per pixel, between the passes
    float tolerance = 0;         // epsilon; used if the number of moments is chosen per fragment
    bool ordered = false;        // fragments are added in order, not by blending

    bool renormalizes() const { return estimation.renormalization != Renormalization::off; }
    bool moves_uncertain() const { return estimation.renormalization == Renormalization::uncertain; }
    bool is_published() const { return estimation.estimate == Estimate::beta && !knows_ends(); }
    bool knows_ends() const { return estimation.ends == RayEnds::known; }
    bool in_own_interval() const { return estimation.interval == MomentInterval::pixel; }

    Estimation estimation = {};
    ParameterValues settings = {};  // all values; those that kernels read are not `auto`
};
ResolvedParameters resolve(const ParameterValues& values, const Technique& technique);

/// Bits per pixel that the technique itself stores, without the colour buffers. 0 if there are none, or if
/// they grow with the number of fragments.
int stored_bits(const Technique& technique, const ParameterValues& values);

/// Bits per pixel that are needed with these parameters. If they ask for one factor per pixel, this is the
/// greater of stored_bits and the bits of the factor with b0, because the factor may replace the moments
/// between the passes. (Momentscope itself keeps both.) Otherwise it is stored_bits.
int bits_with_factor(const Technique& technique, const ParameterValues& values);

/// The numbers of one factored pixel: its b0, its factors, and the ends of its ray if they are known.
int pixel_factor_floats(const Technique& technique, const ResolvedParameters& parameters);

/// The text for a result of stored_bits or bits_with_factor: "160", "none" or "grows with the fragments".
std::string bits_text(const Technique& technique, int bits);

/// Why these values make no sense together for the technique, as a sentence that says what to do. nullptr if
/// they do make sense.
const char* why_refused(const Technique& technique, const ParameterValues& values);

/// True if the fragments of a pixel must be added in order, whatever the parameters: each of them reads the
/// pixel, changes it and writes it.
bool needs_order(const Technique& technique);

/// True if the technique defines a function of depth, which the plot can draw beside the truth.
bool has_function(const Technique& technique);

/// How many pixels a texel of the moments covers in each direction; 1 for techniques with one resolution.
int resolution_divisor(const Technique& technique, const ParameterValues& values);

/// How many sets of moments a pixel stores; 1 for techniques that draw their state in one pass.
int moment_sets(const Technique& technique, const ParameterValues& values);

/// How many samples a pixel has; 0 for techniques without samples.
int sample_count(const Technique& technique, const ParameterValues& values);

/// The value of alpha = auto for the technique with the preset in these values.
float automatic_bias(const ParameterValues& values, const Technique& technique);

/// The argument of make_basis in shaders: epsilon for the basis `nested`, otherwise theta.
float basis_parameter(const ResolvedParameters& parameters, const Technique& technique);

/// The settings of a kernel from resolved parameters.
ReconstructionSettings settings_of(const ResolvedParameters& parameters);

}  // namespace momentscope
