// technique.hpp -- the one registry of techniques.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/parameters.hpp"
#include "core/techniques/basis.hpp"
#include "core/techniques/pixel_state_kernel.hpp"

namespace momentscope {

struct MomentKernel;
struct ReconstructionSettings;

/// A technique that stores moments of the absorbance over depth and reconstructs the transmittance from them.
struct MomentMath {
    const MomentKernel* kernel;  // how C++ evaluates it on a view ray; never null
    const Basis* basis;          // never null
    int moment_count;            // m
    float recommended_bias;      // what alpha = auto means with the preset table1
    float robust_bias;           // and with the preset robust (docs/bias.md)
};

/// A technique that stores something else.
struct PixelStateMath {
    const PixelStateKernel* kernel;                          // never null
    const char* math_file;                                   // shaders/shared/<math_file>.glsl
    PixelStateSettings (*settings)(const ParameterValues&);  // what parameters choose of it
    int (*floats)(const PixelStateSettings&);                // numbers that a pixel stores then
    int (*bits)(const PixelStateSettings&);                  // bits that they need as published
};

/// The right picture, at whatever cost.
struct GroundTruth {
    enum class Way { sorting, peeling } way;
    int bits = 0;  // that a pixel stores; 0 where they grow with the fragments
};

/// One row: everything that is said about a technique anywhere.
struct Technique {
    const char* id;
    const char* name;
    const char* description;  // a short paragraph
    const char* source;       // paper, section, algorithm
    std::variant<MomentMath, PixelStateMath, GroundTruth> math;
    std::vector<ParameterId> parameters = {};  // those that it reads
    int geometry_passes = 1;       // of the transparent geometry; 0 where it grows with the layers
    bool order_dependent = false;  // does the submission order of geometry change the picture?

    bool uses(ParameterId parameter_id) const;

    bool has_moments() const { return std::holds_alternative<MomentMath>(math); }
    bool has_pixel_states() const { return std::holds_alternative<PixelStateMath>(math); }
    bool is_truth() const { return std::holds_alternative<GroundTruth>(math); }

    // Each throws std::bad_variant_access unless the technique is of that kind.
    const MomentMath& moments() const { return std::get<MomentMath>(math); }
    const MomentKernel& moment_kernel() const { return *moments().kernel; }
    const PixelStateMath& pixel_states() const { return std::get<PixelStateMath>(math); }
    const PixelStateKernel& pixel_state_kernel() const { return *pixel_states().kernel; }
    const GroundTruth& truth() const { return std::get<GroundTruth>(math); }

    // False for techniques without moments.
    bool on_circle() const { return has_moments() && moments().basis->on_circle(); }
    bool has_bounds() const {  // do beta = 0 and beta = 1 bound the truth (of the biased moments)?
        return has_moments() && moments().basis->has_bounds();
    }
    bool is_of(BasisFamily family) const { return has_moments() && moments().basis->family == family; }
};

/// All techniques, in the order in which they are listed; ids are unique.
std::span<const Technique> techniques();
std::vector<const Technique*> moment_based_techniques();  // those that have moments
const Technique* find_technique(std::string_view id);     // nullptr when there is none

/// The technique with that id. Throws Error that lists the ids.
const Technique& require_technique(std::string_view id);

/// The least wrapping zone, in radians; 1/125 of the circle. Without a zone depths -1 and 1 are one point,
/// and rounding alone decides at which of them a surface is (docs/stability.md).
constexpr float MIN_WRAPPING_ZONE = 0.05f;

/// The values that a technique computes with: `auto` replaced by its recommendation, theta at least the
/// least.
struct ResolvedParameters {
    float beta = 0, theta = 0, alpha = 0;
    bool textbook = false;       // the solver is Algorithm 1 or 2 as published
    bool factored_once = false;  // per pixel, between the passes
    float tolerance = 0;         // epsilon of orders that are chosen per fragment
    bool ordered = false;        // moments are summed in order, not by blending
    bool renormalize = true;
    PixelStateSettings pixel_state = {};
};
ResolvedParameters resolve(const ParameterValues& values, const Technique& technique);

/// Bits that the technique itself stores of a pixel, beside the colour buffers. 0 for none, or where they
/// grow with the fragments.
int stored_bits(const Technique& technique, const ParameterValues& values);

/// Bits that a pixel needs with these parameters: stored_bits, or those of the factor that takes the moments'
/// place between the passes, if it is larger and the parameters ask for one per pixel.
int bits_with_factor(const Technique& technique, const ParameterValues& values);

/// "160", "none" or "grows with the fragments", for one of the two.
std::string bits_text(const Technique& technique, int bits);

/// Why values make no sense together for the technique, as a sentence that says what to do; nullptr when they
/// do.
const char* why_refused(const Technique& technique, const ParameterValues& values);

/// Must fragments of a pixel be read, changed and written in order whatever the parameters say?
bool needs_order(const Technique& technique);

/// Does the plot have a function of it, beside the truth?
bool has_function(const Technique& technique);

/// What alpha = auto means for the technique under these values' preset.
float automatic_bias(const ParameterValues& values, const Technique& technique);

/// What shaders call make_basis with: theta of the circle, or epsilon of nested orders.
float basis_parameter(const ResolvedParameters& parameters, const Technique& technique);

/// What a kernel is told of them.
ReconstructionSettings settings_of(const ResolvedParameters& parameters);

}  // namespace momentscope
