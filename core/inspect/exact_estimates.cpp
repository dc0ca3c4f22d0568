#include "core/inspect/exact_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/inspect/exact.inl"

namespace momentscope {

namespace {

using Masses = std::vector<reference::PointMass<Real>>;

struct ExactRay {
    Masses masses;
    reference::RaySteps<Real> ends;  // not known if the parameters do not ask for them
    Real total = 0;
};

ExactRay exact_ray(const ViewRay& ray, const ResolvedParameters& parameters) {
    ExactRay result = {any_precision::exact_masses<Real>(ray), {}, 0};
    if (parameters.knows_ends()) result.ends = reference::steps_of_masses<Real>(result.masses);
    for (const auto& mass : result.masses) result.total += mass.absorbance;
    return result;
}

Real own_absorbance(const Fragment& fragment) {
    ViewRay alone;
    alone.fragments = {fragment};
    const Masses masses = any_precision::exact_masses<Real>(alone);
    return masses.empty() ? Real(0) : masses.front().absorbance;
}

// The absorbances in front of a depth and at it.
ExactFraction absorbance_at(const std::optional<ExactFunction>& exact, const ExactRay& ray,
                            const Real& depth) {
    ExactFraction result{0, 0};
    if (exact) {
        const ExactFraction share = (*exact)(depth);
        result.in_front = ray.total * std::clamp(share.in_front, Real(0), Real(1));
        result.query_weight = ray.total * std::clamp(share.query_weight, Real(0), Real(1));
        return result;
    }
    for (const auto& mass : ray.masses) {
        if (mass.depth < depth) result.in_front += mass.absorbance;
        if (mass.depth == depth) result.query_weight += mass.absorbance;
    }
    return result;
}

// The mean of exp(-A) over A in [lower, lower + gap].
Real mean_transmittance(const Real& lower, const Real& gap) {
    using std::exp;
    using std::expm1;
    return gap > 0 ? Real(exp(-lower) * -expm1(-gap) / gap) : Real(exp(-lower));
}

// near, far: is the fragment in the step of this end?
ExactEstimate estimate_between(ExactFraction mass, const Real& own, bool near, bool far, const Real& total,
                               const ResolvedParameters& parameters) {
    using std::exp;
    const bool own_interval = parameters.in_own_interval();
    if (near && (far || own_interval)) mass.in_front = 0;
    if (far && (near || own_interval)) mass.query_weight = total - mass.in_front;
    const Real others = std::max(Real(total - own), Real(0));
    const Real lower = std::min(mass.in_front, others);
    const Real upper = std::min(Real(lower + std::max(Real(mass.query_weight - own), Real(0))), others);
    const auto estimate = parameters.estimation.estimate;
    const auto beta = static_cast<Real>(parameters.beta);
    Real t = exp(-(lower + beta * (upper - lower)));
    if (estimate == Estimate::expected) t = mean_transmittance(lower, upper - lower);
    if (estimate == Estimate::beta && !near && !far)
        t = exp(-std::min(Real(mass.in_front + beta * mass.query_weight), total));
    if (near != far) t = exp(-(near ? lower : upper));  // taken to be alone at this end
    const Real spread = near != far ? Real(0) : Real(t * (exp(-lower) - exp(-upper)));
    return {static_cast<double>(lower), static_cast<double>(upper), static_cast<double>(t),
            static_cast<double>(spread)};
}

// True for bases that core/reference has. Rows of other bases compile, too.
constexpr bool has_reference(BasisId id) {
    return id == BasisId::power || id == BasisId::chebyshev || id == BasisId::nested ||
           id == BasisId::trigonometric;
}

}  // namespace

std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters,
                                           std::span<const std::size_t> places) {
    const ExactRay of_ray = exact_ray(ray, parameters);
    std::vector<ExactEstimate> estimates;
    for (const std::size_t place : places) {
        const auto depth = static_cast<Real>(ray.fragments[place].depth);
        const auto steps = reference::steps_of_depth(depth);
        const bool known = of_ray.ends.known();
        estimates.push_back(
            estimate_between(absorbance_at(exact, of_ray, depth), own_absorbance(ray.fragments[place]),
                             known && steps.near >= of_ray.ends.near, known && steps.far >= of_ray.ends.far,
                             of_ray.total, parameters));
    }
    return estimates;
}

std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters) {
    std::vector<std::size_t> all(ray.fragments.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return exact_estimates(exact, ray, parameters, all);
}

std::vector<double> exact_curve(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                const ResolvedParameters& parameters, std::span<const float> depths) {
    using std::log;
    if (parameters.is_published()) return exact_absorbance(exact, ray, parameters.beta, depths);
    const ExactRay of_ray = exact_ray(ray, parameters);
    std::vector<double> absorbance;
    for (const float at : depths) {
        const auto depth = static_cast<Real>(at);
        const ExactFraction mass = absorbance_at(exact, of_ray, depth);
        const Real gap = std::min(mass.query_weight, Real(of_ray.total - mass.in_front));
        Real result = mass.in_front + static_cast<Real>(parameters.beta) * gap;
        if (parameters.estimation.estimate == Estimate::expected)
            result = -log(mean_transmittance(mass.in_front, gap));
        if (of_ray.ends.known() && depth < of_ray.ends.near_depth()) result = 0;
        if (of_ray.ends.known() && depth > of_ray.ends.far_depth()) result = of_ray.total;
        absorbance.push_back(static_cast<double>(result));
    }
    return absorbance;
}

std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths) {
    if (!technique.has_moments() || !has_reference(technique.moments().basis->id)) return {};
    ResolvedParameters unbiased = parameters;
    unbiased.alpha = 0;
    const auto exact = exact_curve(exact_function(ray, technique, unbiased), ray, parameters, depths);
    return {exact.begin(), exact.end()};
}

}  // namespace momentscope
