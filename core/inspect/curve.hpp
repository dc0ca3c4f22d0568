// curve.hpp -- samples of the functions of depth behind a pixel. The plot draws them and `inspect` prints
// them.
#pragma once
#include <span>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Absorbances at given depths of one ray, for one technique. Each vector is as long as `depth`, or empty if
/// the technique does not define these values.
struct Curve {
    const Technique* technique = nullptr;
    ParameterValues values;            // as the user chose them
    ResolvedParameters parameters{};   // as the technique uses them
    double total_absorbance = 0;       // sum over all fragments, b0
    MomentVector moments;              // as stored by the first pass
    std::vector<float> depth;          // warped, in [-1, 1]
    std::vector<double> truth;         // A(z)
    std::vector<float> reconstructed;  // A(z, b, beta), or -ln T without moments; empty if not has_function
    std::vector<float> beta0, beta1;   // for beta = 0 and 1; bounds if technique->has_bounds()
    std::vector<float> sharp_lower, sharp_upper;  // see sharp_bounds.hpp; empty unless requested
};

/// `samples` evenly spaced depths from -1 to 1. samples >= 2.
std::vector<float> even_depths(std::size_t samples);

/// The absorbance -ln t of a transmittance. If t is 0: the absorbance of an opaque fragment or `total`, the
/// absorbance of the ray, whichever is greater.
double shown_absorbance(double t, double total);

/// The moments that the first pass stores for this ray, summed in submission order with its roundings.
MomentVector sum_moments(const ViewRay& ray, const Technique& technique,
                         const ResolvedParameters& parameters);

/// Evaluates a technique on a ray at `depths`, which lie in [-1, 1].
Curve sample_curve(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                   std::span<const float> depths);

}  // namespace momentscope
