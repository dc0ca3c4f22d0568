// curve.hpp -- the functions behind a pixel, sampled: what the plot draws and what `inspect` prints.
#pragma once
#include <span>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Absorbances of one technique at given depths of one ray. All vectors are as long as `depth`, or empty
/// where the technique has no such thing.
struct Curve {
    const Technique* technique = nullptr;
    ParameterValues values;           // as they were chosen
    ResolvedParameters parameters{};  // as the technique computes with them
    double total_absorbance = 0;      // of the true fragments
    MomentVector moments;             // as the first pass stores them
    std::vector<float> depth;         // warped, [-1, 1]
    std::vector<double> truth;        // A(z)
    std::vector<float>
        reconstructed;  // A(z, b, beta), or -ln T of another technique; empty without has_function
    std::vector<float> beta0, beta1;  // the same for beta = 0 and 1: bounds if technique->has_bounds()
    std::vector<float> sharp_lower, sharp_upper;  // of sharp_bounds.hpp; empty unless asked for
};

/// `samples` depths, evenly from -1 to 1. samples >= 2.
std::vector<float> even_depths(std::size_t samples);

/// The absorbance that a transmittance shows: -ln T. Where T is 0 that of an opaque fragment, or `total`, the
/// ray's absorbance, if it is more.
double shown_absorbance(double t, double total);

/// The moments that the first pass sums up for this ray, in submission order, in floats.
MomentVector sum_moments(const ViewRay& ray, const Technique& technique,
                         const ResolvedParameters& parameters);

/// Evaluates a technique on a ray at `depths` in [-1, 1].
Curve sample_curve(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                   std::span<const float> depths);

}  // namespace momentscope
