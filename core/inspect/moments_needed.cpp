#include "core/inspect/moments_needed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/curve.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

std::vector<float> depths_that_absorb(const ViewRay& ray) {
    std::vector<float> depths;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.opacity > 0) depths.push_back(fragment.depth);
    return depths;
}

// The absorbance at one depth. Fragments there count as one, because no moments tell them apart.
double absorbance_at(const ViewRay& ray, float depth) {
    double sum = 0;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.depth == depth) sum += static_cast<double>(fragment_absorbance(fragment.opacity));
    return sum;
}

template <typename Measure>
Needed first_within(const MomentOrders& orders, const ParameterValues& values, const Measure& measure) {
    const auto tolerance = static_cast<double>(values.number(ParameterId::tolerance));
    for (std::size_t i = 0; i < orders.size(); ++i)
        if (measure(*orders[i]) <= tolerance)
            return static_cast<Needed>(static_cast<std::size_t>(Needed::four) + i);
    return Needed::more;
}

}  // namespace

MomentOrders moment_orders(std::string_view basis) {
    const char* prefix = basis == "power" ? "power" : basis == "chebyshev" ? "cheb" : nullptr;
    if (prefix == nullptr)
        throw Error(fmt::format("'{}' is not a basis with bounds; choose power or chebyshev.", basis));
    MomentOrders orders{};
    for (std::size_t i = 0; i < orders.size(); ++i)
        orders[i] = &require_technique(fmt::format("{}{}-32", prefix, 4 + 2 * i));
    return orders;
}

double certified_gap(const ViewRay& ray, const Technique& technique, const ParameterValues& values) {
    const auto estimates = fragment_estimates(ray, technique, resolve(values, technique));
    double most = 0;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        if (!(fragment.opacity > 0)) continue;
        const auto lower = static_cast<double>(estimates[i].lower);
        const double at_same_depth =
            absorbance_at(ray, fragment.depth) - static_cast<double>(fragment_absorbance(fragment.opacity));
        const double uncertain =
            std::max(static_cast<double>(estimates[i].upper) - lower - at_same_depth, 0.0);
        most = std::max(most, std::exp(-lower) * -std::expm1(-uncertain));
    }
    return most;
}

double greatest_error(const ViewRay& ray, const Technique& technique, const ParameterValues& values) {
    const ResolvedParameters parameters = resolve(values, technique);
    const auto estimates = fragment_estimates(ray, technique, parameters);
    const std::vector<double> truth = true_absorbance(ray, own_depths(ray));
    const auto beta = static_cast<double>(parameters.beta);
    double most = 0;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        if (!(fragment.opacity > 0)) continue;
        const double here = absorbance_at(ray, fragment.depth);
        const double others = here - static_cast<double>(fragment_absorbance(fragment.opacity));
        const auto t = static_cast<double>(estimates[i].transmittance);
        // A published estimate occludes itself by choice. Of several fragments at one depth, any may be
        // first.
        const bool by_beta = parameters.estimation.estimate == Estimate::beta;
        const double greatest = std::exp(-(truth[i] + (by_beta ? beta * here : 0)));
        const double least = by_beta ? greatest : std::exp(-(truth[i] + others));
        most = std::max({most, t - greatest, least - t});
    }
    return most;
}

std::string needed_text(Needed needed) {
    constexpr std::array TEXTS = {"nothing", "4", "6", "8", "more than 8"};
    return TEXTS[static_cast<std::size_t>(needed)];
}

PixelNeed pixel_need(const ViewRay& ray, const MomentOrders& orders, const ParameterValues& values) {
    if (depths_that_absorb(ray).empty()) return {};
    return {first_within(orders, values,
                         [&](const Technique& order) { return certified_gap(ray, order, values); }),
            first_within(orders, values,
                         [&](const Technique& order) { return greatest_error(ray, order, values); })};
}

NeedHistogram count_needs(std::span<const PixelNeed> pixels) {
    NeedHistogram histogram;
    for (const PixelNeed& pixel : pixels) {
        ++histogram.by_certificate[static_cast<std::size_t>(pixel.by_certificate)];
        ++histogram.by_error[static_cast<std::size_t>(pixel.by_error)];
        histogram.cautious += pixel.by_certificate > pixel.by_error ? 1 : 0;
        histogram.overlooked += pixel.by_certificate < pixel.by_error ? 1 : 0;
    }
    return histogram;
}

double tiled_memory(std::span<const PixelNeed> pixels, int width, int tile) {
    constexpr std::array NUMBERS = {0, 5, 7, 9, 9};  // by Needed; includes b_0
    const int height = static_cast<int>(pixels.size()) / width;
    long stored = 0;
    for (int top = 0; top < height; top += tile)
        for (int left = 0; left < width; left += tile) {
            Needed most = Needed::nothing;
            const int right = std::min(left + tile, width), bottom = std::min(top + tile, height);
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    most = std::max(most, pixels[static_cast<std::size_t>(y * width + x)].by_certificate);
            stored +=
                static_cast<long>(right - left) * (bottom - top) * NUMBERS[static_cast<std::size_t>(most)];
        }
    return static_cast<double>(stored) / (9.0 * static_cast<double>(pixels.size()));
}

}  // namespace momentscope
