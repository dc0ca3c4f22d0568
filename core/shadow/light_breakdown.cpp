#include "core/shadow/light_breakdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/exact_estimates.hpp"

namespace momentscope {

namespace {

constexpr double VISIBLE = 0.01;  // smaller shares of the light are not explained

/// T from exact moments without bias; nullopt if there is no such T. own: the absorbance of the receiver, of
/// which nothing lies in front of it.
std::optional<double> exact_transmittance(const ViewRay& ray, const Technique& technique,
                                          ResolvedParameters parameters, float beta, float depth,
                                          double own) {
    const auto at = [&](float weight) {
        parameters.beta = weight;
        return unbiased_absorbance(ray, technique, parameters, {&depth, 1});
    };
    const std::vector<float> lower = at(0), upper = at(1);
    if (lower.empty()) return std::nullopt;
    const auto low = static_cast<double>(lower.front());
    const double others = std::max(static_cast<double>(upper.front()) - low - own, 0.0);
    return std::exp(-(low + static_cast<double>(beta) * others));
}

// A chain from the truth to the shown light, with one cause per step.
std::vector<Contribution> contributions_of(const ShadowFilterSamples& bundle,
                                           const Configuration& transparent, double truth, double shown) {
    const Technique& technique = *transparent.technique;
    if (technique.is_truth() || bundle.texels.empty()) return {};
    const float depth = bundle.place.depth;
    const double mixed = mixed_transmittance(bundle, depth);
    std::vector<Contribution> chain = {{"filtering", truth - mixed}};
    const ViewRay ray = mixed_ray(bundle);
    const ResolvedParameters parameters = resolve(transparent.values, technique);
    const auto own = static_cast<double>(bundle.receiver_absorbance);
    const auto lower = exact_transmittance(ray, technique, parameters, 0, depth, own);
    const auto weighted = exact_transmittance(ray, technique, parameters, parameters.beta, depth, own);
    if (!lower || !weighted) {
        chain.push_back({"the series", mixed - shown});
        return chain;
    }
    chain.push_back({"light leaking", mixed - *lower});
    chain.push_back({"self-shadowing", *lower - *weighted});
    chain.push_back({"bias and rounding", *weighted - shown});
    return chain;
}

std::string reason(const Contribution& cause, const Configuration& transparent) {
    const double percent = 100 * std::abs(cause.share);
    if (cause.cause == "light leaking" && cause.share < 0)
        return fmt::format(
            "light leaks: the moments also fit mass behind the receiver, which lets {:.0f} % too much through",
            percent);
    if (cause.cause == "light leaking")
        return fmt::format(
            "the moments also fit mass in front of the receiver, which takes {:.0f} % of the light", percent);
    if (cause.cause == "self-shadowing")
        return fmt::format(
            "wrong self-shadowing: β = {:g} counts mass at the receiver's own depth as in front, {:.0f} % of the "
            "light",
            static_cast<double>(transparent.values.number(ParameterId::beta)), percent);
    if (cause.cause == "filtering")
        return fmt::format("filtering averages absorbances instead of transmittances, {:.0f} % of the light",
                           percent);
    if (cause.cause == "the series")
        return fmt::format("the Fourier series rings and smears: {:.0f} % of the light {}", percent,
                           cause.share < 0 ? "too much" : "too little");
    return fmt::format("bias and rounding change {:.0f} % of the light", percent);
}

}  // namespace

LightBreakdown light_breakdown(const ShadowFilterSamples& bundle, const Configuration& transparent,
                               const OpaqueShadow& opaque) {
    const float depth = bundle.place.depth;
    LightBreakdown breakdown;
    if (!bundle.place.within) {
        breakdown.sentence = "The light's map does not cover this place, so all light reaches it.";
        return breakdown;
    }
    breakdown.true_transmittance = deep_transmittance(bundle, depth);
    breakdown.transmittance = static_cast<double>(light_transmittance(bundle, transparent, depth));
    breakdown.true_shadowed =
        static_cast<double>(light_shadowed(bundle, require_opaque_shadow("pcf"), depth));
    breakdown.shadowed = static_cast<double>(light_shadowed(bundle, opaque, depth));
    breakdown.contributions =
        contributions_of(bundle, transparent, breakdown.true_transmittance, breakdown.transmittance);
    const double truth = (1 - breakdown.true_shadowed) * breakdown.true_transmittance;
    const double shown = (1 - breakdown.shadowed) * breakdown.transmittance;
    breakdown.sentence =
        fmt::format("{:.0f} % of the light should reach it, and {:.0f} % does", 100 * truth, 100 * shown);
    const auto by_size = [](const Contribution& a, const Contribution& b) {
        return std::abs(a.share) < std::abs(b.share);
    };
    const double off_transparent = std::abs(breakdown.true_transmittance - breakdown.transmittance);
    const double off_opaque = std::abs(breakdown.true_shadowed - breakdown.shadowed);
    if (std::max(off_transparent, off_opaque) < VISIBLE)
        breakdown.sentence += ".";
    else if (off_opaque > off_transparent)
        breakdown.sentence += fmt::format(
            ": {} opaque casters, because {:.0f} % of the filter region lies in front and the map says {:.0f} %.",
            breakdown.shadowed < breakdown.true_shadowed ? "light leaks past" : "it is too dark below",
            100 * breakdown.true_shadowed, 100 * breakdown.shadowed);
    else
        breakdown.sentence += fmt::format(
            ": {}.", reason(*std::ranges::max_element(breakdown.contributions, by_size), transparent));
    return breakdown;
}

}  // namespace momentscope
