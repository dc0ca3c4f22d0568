#include "core/stress/classify.hpp"

#include <algorithm>
#include <cmath>

namespace momentscope {

Outcome classify(float fraction, double t, double exact_t) {
    if (!std::isfinite(fraction)) return Outcome::no_number;
    if (!(fraction >= -CLAMP_TOLERANCE && fraction <= 1 + CLAMP_TOLERANCE)) return Outcome::outside;
    return std::abs(t - exact_t) > FAILED_ERROR ? Outcome::inaccurate : Outcome::ok;
}

double transmittance_of_fraction(float fraction, float b0) {
    const double clamped = fraction >= 0 ? std::min(static_cast<double>(fraction), 1.0) : 0.0;
    return std::exp(-static_cast<double>(b0) * clamped);
}

std::vector<std::size_t> some_fragments(const ViewRay& ray) {
    constexpr std::size_t MOST = 8;
    const std::size_t step = std::max<std::size_t>(ray.fragments.size() / MOST, 1);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < ray.fragments.size() && places.size() < MOST; i += step) places.push_back(i);
    return places;
}

std::vector<float> some_own_depths(const ViewRay& ray) {
    std::vector<float> depths;
    for (const std::size_t i : some_fragments(ray)) depths.push_back(ray.fragments[i].depth);
    return depths;
}

}  // namespace momentscope
