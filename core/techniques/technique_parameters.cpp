// technique_parameters.cpp -- what values of parameters mean for a technique, and which make no sense
// together.
#include <algorithm>

#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

float automatic_bias(const ParameterValues& values, const Technique& technique) {
    if (technique.has_moments())
        return values.get<BiasPreset>() == BiasPreset::robust ? technique.moments().robust_bias
                                                              : technique.moments().recommended_bias;
    if (!technique.uses(ParameterId::alpha)) return 0;
    return values.get<ReadFormat>() == ReadFormat::theta16 ? 6.0e-5f : 3.0e-7f;  // Sharpe 2018
}

int resolution_divisor(const Technique& technique, const ParameterValues& values) {
    return technique.uses(ParameterId::resolution) ? 1 << static_cast<int>(values.get<MomentResolution>())
                                                   : 1;
}

int moment_sets(const Technique& technique, const ParameterValues& values) {
    return technique.uses(ParameterId::moment_passes) && values.get<MomentSets>() != MomentSets::one ? 2 : 1;
}

int sample_count(const Technique& technique, const ParameterValues& values) {
    return technique.uses(ParameterId::samples) ? values.count(ParameterId::samples) : 0;
}

namespace {

Estimation estimation_of(const ParameterValues& values, const Technique& technique) {
    if (technique.has_moments() && technique.moments().estimation) return *technique.moments().estimation;
    if (!technique.uses(ParameterId::estimate)) return {.renormalization = values.get<Renormalization>()};
    return {values.get<Estimate>(), values.get<RayEnds>(), values.get<MomentInterval>(),
            values.get<Renormalization>()};
}

}  // namespace

ResolvedParameters resolve(const ParameterValues& values, const Technique& technique) {
    const bool textbook = technique.uses(ParameterId::solver) && values.get<Solver>() == Solver::textbook;
    const bool ordered = technique.uses(ParameterId::accumulation) &&
                         values.get<MomentAccumulation>() == MomentAccumulation::ordered;
    const float alpha = values[ParameterId::alpha].value_or(automatic_bias(values, technique));
    ParameterValues settings = values;
    settings.set(ParameterId::alpha, alpha);
    return {
        .beta = values.number(ParameterId::beta),
        .theta = std::max(values.number(ParameterId::theta), MIN_WRAPPING_ZONE),
        .alpha = alpha,
        .textbook = textbook,
        .factored_once = technique.uses(ParameterId::factorisation) &&
                         values.get<Factorisation>() == Factorisation::per_pixel && !textbook,
        .tolerance = technique.uses(ParameterId::tolerance) ? values.number(ParameterId::tolerance) : 0.0f,
        .ordered = ordered || needs_order(technique),
        .estimation = estimation_of(values, technique),
        .settings = settings};
}

namespace {

// Why these ways to estimate T make no sense together; nullptr if they do.
const char* why_no_estimate(const Technique& technique, const ParameterValues& values) {
    const Estimation chosen = resolve(values, technique).estimation;
    const bool uncertain = chosen.renormalization == Renormalization::uncertain;
    if (!technique.has_moments())
        return uncertain
                   ? "Only techniques with moments know which fragments are uncertain: renormalise uniformly, or not at all."
                   : nullptr;
    const bool own_interval = chosen.interval == MomentInterval::pixel;
    if (own_interval && chosen.ends == RayEnds::off)
        return "The pixel's own interval lies between the ends of its ray: set the ends to known.";
    if (own_interval && technique.moments().basis->chooses_order)
        return "The adaptive order is chosen by the bounds of the whole line: leave the interval at scene.";
    if (own_interval && !technique.on_circle() && technique.moments().basis->depth_per_unit() != 1)
        return "The sharp bounds of the pixel's own interval need moments of depths in [-1, 1]: leave the interval at scene.";
    if (uncertain && chosen.estimate == Estimate::beta)
        return "What is uncertain shows only after a fragment's own absorbance is taken out: set the estimate to own-beta "
               "or expected.";
    const bool published = chosen.estimate == Estimate::beta && chosen.ends == RayEnds::off && !uncertain;
    if (resolve(values, technique).textbook && !published)
        return "Algorithms 1 and 2 as published give no bounds: set the solver to robust, or the estimate to beta and the ends "
               "to off.";
    return nullptr;
}

}  // namespace

const char* why_refused(const Technique& technique, const ParameterValues& values) {
    if (const char* why = why_no_estimate(technique, values); why != nullptr) return why;
    const bool low =
        technique.uses(ParameterId::resolution) && values.get<MomentResolution>() != MomentResolution::full;
    const auto format = values.get<ReadFormat>();
    if (low && (format == ReadFormat::nlqm64 || format == ReadFormat::nlqm32))
        return "Non-linearly quantised moments cannot be filtered: read them at full resolution, or choose the read "
               "format float or theta16.";
    return nullptr;
}

float basis_parameter(const ResolvedParameters& parameters, const Technique& technique) {
    return technique.uses(ParameterId::tolerance) ? parameters.tolerance : parameters.theta;
}

ReconstructionSettings settings_of(const ResolvedParameters& parameters) {
    return {.overestimation = parameters.beta,
            .wrapping_zone_angle = parameters.theta,
            .tolerance = parameters.tolerance,
            .bias = parameters.alpha,
            .solver = parameters.textbook ? Solver::textbook : Solver::robust,
            .estimate = parameters.estimation.estimate,
            .ends = parameters.estimation.ends,
            .interval = parameters.estimation.interval};
}

}  // namespace momentscope
