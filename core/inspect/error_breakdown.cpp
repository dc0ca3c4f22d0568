#include "core/inspect/error_breakdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/error_causes.hpp"
#include "core/inspect/exact_estimates.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

namespace {

constexpr double MIN_ERROR_TO_EXPLAIN = 1e-3;  // smaller errors need no explanation

constexpr std::size_t MAX_FRAGMENTS = 1000;  // exact arithmetic is slow

/// One step of the chain from the truth to the technique: its cause, and the colour after it.
struct Step {
    std::string cause;
    glm::dvec3 color;
};

// The composite of these estimates, which have a transmittance and a spread each.
template <typename Estimates>
glm::dvec3 color_of_estimates(const ViewRay& ray, const Estimates& estimates,
                              const ResolvedParameters& parameters, const glm::vec3& behind) {
    glm::vec4 weighted(0), uncertain(0);
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const glm::vec4 covered = glm::vec4(ray.fragments[i].color, 1) * ray.fragments[i].opacity;
        weighted += covered * static_cast<float>(estimates[i].transmittance);
        uncertain += covered * static_cast<float>(estimates[i].spread);
    }
    return composited_color(weighted, uncertain, static_cast<float>(total_absorbance(ray)), parameters,
                            behind);
}

// No function of depth can tell which of two surfaces at the same depth lies in front. Neither occludes the
// other.
void add_step_of_ties(std::vector<Step>& steps, const ViewRay& ray, const ResolvedParameters& parameters,
                      const glm::vec3& behind) {
    if (!has_ties(ray)) return;
    std::vector<ExactEstimate> truth;
    for (const double absorbance : true_absorbance(ray, own_depths(ray)))
        truth.push_back({absorbance, absorbance, std::exp(-absorbance), 0});
    steps.push_back({cause::SAME_DEPTH, color_of_estimates(ray, truth, parameters, behind)});
}

// The technique whose exact function is used. All bases on the line hold the same information as the same
// number of power moments.
const Technique& with_reference(const Technique& technique) {
    if (technique.on_circle() || technique.moments().basis->id == BasisId::power) return technique;
    return require_technique(fmt::format("power{}-32", technique.moments().moment_count));
}

std::vector<Step> moment_steps(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                               const glm::vec3& behind) {
    const ResolvedParameters parameters = resolve(values, technique);
    const Technique& reference = with_reference(technique);
    const bool by_beta = parameters.estimation.estimate != Estimate::expected;
    ResolvedParameters exact = parameters;  // changes from step to step
    std::vector<Step> steps;
    const auto add = [&](std::string cause) {
        const auto estimates = exact_estimates(exact_function(ray, reference, exact), ray, exact);
        steps.push_back({std::move(cause), color_of_estimates(ray, estimates, parameters, behind)});
    };
    add_step_of_ties(steps, ray, parameters, behind);
    exact.alpha = 0;
    if (technique.on_circle()) exact.theta = MIN_WRAPPING_ZONE;
    if (by_beta) {
        exact.estimation.estimate = Estimate::own_beta;
        exact.beta = 0;
    }
    add(fmt::format("{} ({} {} moments for {})", cause::MOMENT_COUNT, technique.moments().moment_count,
                    family_name(technique.moments().basis->family),
                    fragment_count_text(ray.fragments.size())));
    exact.theta = parameters.theta;
    if (technique.on_circle()) add(cause::WRAPPING_ZONE);
    if (by_beta) {
        exact.beta = parameters.beta;
        add(cause::OVERESTIMATION);
    }
    if (parameters.estimation.estimate == Estimate::beta) {
        exact.estimation.estimate = Estimate::beta;
        add(cause::SELF_OCCLUSION);
    }
    exact.alpha = parameters.alpha;
    if (&reference == &technique) add(cause::BIAS);
    steps.push_back(
        {&reference != &technique               ? cause::BIAS
         : technique.moment_kernel().bits == 16 ? cause::DRIFT
         : parameters.textbook                  ? cause::TEXTBOOK
                                                : cause::ROUNDING,
         color_of_estimates(ray, fragment_estimates(ray, technique, parameters), parameters, behind)});
    return steps;
}

// The ray in the order of submission that suits a technique best: front to back if it merges fragments that
// come late, back to front if the last fragment lies on top.
ViewRay best_ordered(const ViewRay& ray, Accumulation accumulation) {
    ViewRay sorted = ray;
    std::vector<std::size_t> places = front_to_back(ray);
    if (accumulation == Accumulation::over) std::ranges::reverse(places);
    for (std::size_t i = 0; i < places.size(); ++i) sorted.fragments[i] = ray.fragments[places[i]];
    return sorted;
}

std::vector<Step> pixel_state_steps(const ViewRay& ray, const Technique& technique,
                                    const ParameterValues& values, const glm::vec3& behind) {
    const ViewRay sorted =
        technique.order_dependent ? best_ordered(ray, technique.pixel_state_kernel().accumulation) : ray;
    ParameterValues ideal = values;
    std::vector<Step> steps;
    if (!technique.pixel_state_kernel().holds_colors && technique.pixel_state_kernel().has_depths())
        add_step_of_ties(steps, ray, resolve(values, technique), behind);
    const auto add = [&](const char* cause, const ViewRay& of) {
        const ResolvedParameters parameters = resolve(ideal, technique);
        steps.push_back({cause, glm::dvec3(pixel_state_color(of, technique, parameters, behind))});
    };
    if (technique.uses(ParameterId::layer_bits)) ideal.set(LayerBits::bits_32);
    if (technique.uses(ParameterId::resolution)) {
        ideal.set(MomentResolution::full);
        ideal.set(ReadFormat::floats);
    }
    add(cause::METHOD, sorted);
    for (const ParameterId id : {ParameterId::layer_bits, ParameterId::read_format}) {
        if (!technique.uses(id)) continue;
        ideal.set(id, values[id]);
        add(cause::FEW_BITS, sorted);
    }
    if (technique.uses(ParameterId::resolution)) {
        ideal.set(values.get<MomentResolution>());
        add(cause::LOW_RESOLUTION, sorted);
    }
    if (technique.order_dependent) add(cause::ORDER, ray);
    return steps;
}

ErrorBreakdown breakdown_of_truth(const ViewRay& ray, const Technique& technique, const glm::vec3& behind) {
    const std::size_t lost = ray.fragments.size() - drawn_fragments(ray, technique).fragments.size();
    if (lost == 0) return {.error = 0, .contributions = {}, .sentence = "This technique is the truth."};
    const PixelColors colors = pixel_colors(ray, {}, technique, {}, behind);
    const double error = glm::length(glm::dvec3(colors.technique) - glm::dvec3(colors.truth));
    return {.error = error,
            .contributions = {{cause::SAME_DEPTH, error}},
            .sentence = fmt::format(
                "Off by {:.3f} in linear colour: of several surfaces at the same depth, only the one "
                "that is drawn first survives, so {} of {} is lost.",
                error, lost, fragment_count_text(ray.fragments.size()))};
}

// A sentence on what a half float loses of b0, or an empty text.
std::string drift_text(const ViewRay& ray, const Technique& technique, const ParameterValues& values) {
    constexpr double DRIFT = 0.01;
    if (!technique.has_moments() || technique.moment_kernel().bits != 16) return {};
    const double total = total_absorbance(ray);
    const auto stored = static_cast<double>(sum_moments(ray, technique, resolve(values, technique)).b0);
    if (std::abs(stored - total) <= DRIFT * total) return {};
    return fmt::format(
        " In 16 bits b₀ = {:.6g} instead of {:.6g}: every sum is rounded to the 11 "
        "bits of a half float; use moments in 32 bits.",
        stored, total);
}

std::string sentence_of(const ErrorBreakdown& breakdown) {
    if (breakdown.error < MIN_ERROR_TO_EXPLAIN)
        return fmt::format("Right to {:.4f} in linear colour.", breakdown.error);
    const auto greatest = std::ranges::max_element(breakdown.contributions, {}, &Contribution::share);
    std::string text = fmt::format("Off by {:.3f} in linear colour, mostly because of {}: {:+.3f}",
                                   breakdown.error, greatest->cause, greatest->share);
    for (const Contribution& other : breakdown.contributions)
        if (&other != &*greatest && std::abs(other.share) >= 0.02 * breakdown.error)
            text += fmt::format("; {} {:+.3f}", other.cause, other.share);
    return text + ".";
}

PixelColors colors_of(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                      const glm::vec3& behind) {
    const std::vector<PixelHistoryRow> rows = pixel_history(ray, {}, technique, values);
    return pixel_colors(ray, rows, technique, resolve(values, technique), behind);
}

// True if the pixel is worse with renormalisation than without. Only then is renormalisation a cause;
// otherwise the remaining error has other causes.
bool harmful_renormalization(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                             const glm::vec3& behind, double error) {
    if (!technique.uses(ParameterId::renormalize) || !resolve(values, technique).renormalizes()) return false;
    ParameterValues without = values;
    without.set(Renormalization::off);
    const PixelColors colors = colors_of(ray, technique, without, behind);
    return glm::length(glm::dvec3(colors.technique) - glm::dvec3(colors.truth)) < error;
}

}  // namespace

ErrorBreakdown pixel_error_breakdown(const ViewRay& ray, const Technique& technique,
                                     const ParameterValues& values, const glm::vec3& behind) {
    if (technique.is_truth()) return breakdown_of_truth(ray, technique, behind);
    if (ray.fragments.size() > MAX_FRAGMENTS)
        return {.error = 0,
                .contributions = {},
                .sentence = fmt::format("This ray has more than {} fragments, too many for a verdict.{}",
                                        MAX_FRAGMENTS, drift_text(ray, technique, values))};
    const PixelColors colors = colors_of(ray, technique, values, behind);
    ErrorBreakdown breakdown;
    if (ray.fragments.empty()) {
        breakdown.sentence = "Nothing here is transparent, so nothing is wrong.";
        return breakdown;
    }
    const glm::dvec3 truth(colors.truth), shown(colors.technique);
    breakdown.error = glm::length(shown - truth);
    ParameterValues chained = values;
    if (harmful_renormalization(ray, technique, values, behind, breakdown.error))
        chained.set(Renormalization::off);  // renormalisation becomes the last step
    std::vector<Step> steps = technique.has_pixel_states()
                                  ? pixel_state_steps(ray, technique, chained, behind)
                                  : moment_steps(ray, technique, chained, behind);
    if (chained != values) steps.push_back({cause::RENORMALISATION, shown});
    const glm::dvec3 direction = breakdown.error > 0 ? (shown - truth) / breakdown.error : glm::dvec3(0);
    glm::dvec3 before = truth;
    for (const Step& step : steps) {
        breakdown.contributions.push_back({step.cause, glm::dot(step.color - before, direction)});
        before = step.color;
    }
    breakdown.sentence = sentence_of(breakdown) + drift_text(ray, technique, values);
    return breakdown;
}

}  // namespace momentscope
