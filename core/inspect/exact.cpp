#include "core/inspect/exact.hpp"

#include "core/inspect/exact.inl"

#include <numeric>

namespace momentscope {

namespace {

// True for bases that core/reference has. Rows of other bases compile, too.
constexpr bool has_reference(BasisId id) {
    return id == BasisId::power || id == BasisId::chebyshev || id == BasisId::nested ||
           id == BasisId::trigonometric;
}

}  // namespace

std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters) {
    return any_precision::exact_function<Real>(ray, technique, parameters);
}

std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters) {
    return any_precision::exact_function_of_stored<Real>(stored, technique, parameters);
}

std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths) {
    const auto masses = any_precision::exact_masses<Real>(ray);
    const auto here = static_cast<Real>(beta);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    std::vector<double> absorbance;
    absorbance.reserve(depths.size());
    for (const float depth : depths) {
        const auto at = static_cast<Real>(depth);
        if (exact) {
            const Real share = (*exact)(at).with(beta);
            absorbance.push_back(static_cast<double>(total * std::clamp(share, Real(0), Real(1))));
        } else {
            Real sum = 0;
            for (const auto& mass : masses)
                if (mass.depth <= at) sum += mass.absorbance * (mass.depth < at ? 1 : here);
            absorbance.push_back(static_cast<double>(sum));
        }
    }
    return absorbance;
}

namespace {

// The mean of exp(-A) over A in [lower, lower + gap].
Real mean_transmittance(const Real& lower, const Real& gap) {
    using std::exp;
    using std::expm1;
    return gap > 0 ? Real(exp(-lower) * -expm1(-gap) / gap) : Real(exp(-lower));
}

// The steps of the ends of a ray; not known if the parameters do not ask for them.
any_precision::RaySteps<Real> steps_of(const std::vector<reference::PointMass<Real>>& masses,
                                       const ResolvedParameters& parameters) {
    if (!parameters.knows_ends()) return {};
    return any_precision::steps_of_masses<Real>(masses);
}

}  // namespace

std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters) {
    std::vector<std::size_t> all(ray.fragments.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return exact_estimates(exact, ray, parameters, all);
}

std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters,
                                           std::span<const std::size_t> places) {
    using std::exp;
    const auto masses = any_precision::exact_masses<Real>(ray);
    const auto steps = steps_of(masses, parameters);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    const auto absorbance_at = [&](const Real& depth) {  // in front of the depth, and at it
        Real in_front = 0, at = 0;
        for (const auto& mass : masses) {
            if (mass.depth < depth) in_front += mass.absorbance;
            if (mass.depth == depth) at += mass.absorbance;
        }
        return ExactFraction{in_front, at};
    };
    std::vector<ExactEstimate> estimates;
    for (const std::size_t place : places) {
        const Fragment& fragment = ray.fragments[place];
        ViewRay alone;
        alone.fragments = {fragment};
        const auto mass = any_precision::exact_masses<Real>(alone);
        const Real own = mass.empty() ? Real(0) : mass.front().absorbance;
        const auto depth = static_cast<Real>(fragment.depth);
        const auto of_depth = any_precision::steps_of_depth(depth);
        const bool near = steps.known() && of_depth.near >= steps.near;
        const bool far = steps.known() && of_depth.far >= steps.far;
        ExactFraction share;
        if (!exact) share = absorbance_at(depth);
        if (exact) {
            const ExactFraction fraction = (*exact)(depth);
            share = {total * std::clamp(fraction.in_front, Real(0), Real(1)),
                     total * std::clamp(fraction.query_weight, Real(0), Real(1))};
        }
        if (near && (far || parameters.in_own_interval())) share.in_front = 0;
        if (far && (near || parameters.in_own_interval())) share.query_weight = total - share.in_front;
        const Real others = std::max(Real(total - own), Real(0));
        const Real lower = std::min(share.in_front, others);
        const Real upper = std::min(Real(lower + std::max(Real(share.query_weight - own), Real(0))), others);
        const auto beta = static_cast<Real>(parameters.beta);
        const bool published = parameters.estimation.estimate == Estimate::beta && !near && !far;
        Real absorbance = published ? std::min(Real(share.in_front + beta * share.query_weight), total)
                                    : Real(lower + beta * (upper - lower));
        if (near != far) absorbance = near ? lower : upper;
        const bool expected = parameters.estimation.estimate == Estimate::expected && near == far;
        const Real t = expected ? mean_transmittance(lower, upper - lower) : Real(exp(-absorbance));
        const Real spread = near != far ? Real(0) : Real(t * (exp(-lower) - exp(-upper)));
        estimates.push_back({static_cast<double>(lower), static_cast<double>(upper), static_cast<double>(t),
                             static_cast<double>(spread)});
    }
    return estimates;
}

std::vector<double> exact_curve(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                const ResolvedParameters& parameters, std::span<const float> depths) {
    using std::log;
    if (parameters.estimation.estimate == Estimate::beta && !parameters.knows_ends())
        return exact_absorbance(exact, ray, parameters.beta, depths);
    const std::vector<double> lower = exact_absorbance(exact, ray, 0, depths);
    const std::vector<double> upper = exact_absorbance(exact, ray, 1, depths);
    const auto masses = any_precision::exact_masses<Real>(ray);
    const auto steps = steps_of(masses, parameters);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    std::vector<double> absorbance;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto depth = static_cast<Real>(depths[i]);
        const Real low = lower[i], gap = upper[i] - lower[i];
        const Real beta = parameters.beta;
        Real at = parameters.estimation.estimate == Estimate::expected
                      ? Real(-log(mean_transmittance(low, gap)))
                      : Real(low + beta * gap);
        const Real half = static_cast<Real>(any_precision::END_STEPS) / 2;
        if (steps.known() && depth < 1 - steps.near / half) at = 0;
        if (steps.known() && depth > steps.far / half - 1) at = total;
        absorbance.push_back(static_cast<double>(at));
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
