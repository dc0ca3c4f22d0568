// technique.hpp -- the one registry of techniques.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"
#include "core/techniques/pixel_state_kernel.hpp"

namespace momentscope {

struct MomentKernel;
struct ReconstructionSettings;

/// Which passes render a technique (core/render).
enum class RenderPath { moments, states, sorted, peeling };

/// One row: everything that is said about a technique anywhere.
struct Technique {
    const char* id;
    const char* name;
    const char* description;  // a short paragraph
    const char* source;       // paper, section, algorithm
    RenderPath path;
    const MomentKernel* kernel = nullptr;  // how C++ evaluates it on a view ray; null for the truth itself
    const char* basis = nullptr;           // shaders/shared/<basis>_moments.glsl, or null
    int moment_count = 0;                  // m
    const char* math_file = nullptr;       // shaders/shared/<math_file>.glsl of techniques without moments
    const PixelStateKernel* pixel_state = nullptr;  // of techniques that store something else than moments
    PixelStateSettings (*pixel_state_settings)(const ParameterValues&) =
        nullptr;                                               // what parameters choose of it
    int (*state_floats)(const PixelStateSettings&) = nullptr;  // numbers that a pixel stores then
    int (*state_bits)(const PixelStateSettings&) = nullptr;    // bits that they need as published
    std::vector<ParameterId> parameters = {};                  // those that it reads
    float recommended_bias = 0;    // what alpha = auto means with the preset table1
    float robust_bias = 0;         // and with the preset robust (docs/bias.md)
    bool has_bounds = false;       // beta = 0 and beta = 1 bound the truth (of the biased moments)
    int truth_bits = 0;            // stored bits of a truth; 0 where they grow with the fragments
    int geometry_passes = 1;       // of the transparent geometry; 0 where it grows with the layers
    bool order_dependent = false;  // does the submission order of geometry change the picture?

    bool uses(ParameterId parameter_id) const;
    bool on_circle() const { return basis != nullptr && std::string_view(basis) == "trigonometric"; }
    bool on_chebyshev() const {  // are its moments those of Chebyshev polynomials?
        return basis != nullptr &&
               (std::string_view(basis) == "chebyshev" || std::string_view(basis) == "nested");
    }
    bool is_truth() const { return kernel == nullptr && pixel_state == nullptr; }
};

/// All techniques, in the order in which they are listed; ids are unique.
std::span<const Technique> techniques();
std::vector<const Technique*> moment_based_techniques();  // those with a moment kernel
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
