#include "core/compare/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "core/compare/color_spaces.hpp"
#include "core/compare/flip.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr MetricRow ROWS[] = {
    {Metric::rmse, "rmse", "root mean square error", "RMSE",
     "Over the three linear channels; 0 for equal pictures. How much a pixel adds depends on its own error only.",
     "Münstermann et al. 2018, Section 7", 0.25f},
    {Metric::delta_e, "delta-e", "CIELAB ΔE", "ΔE",
     "Mean distance in CIELAB under D65: about 2 is just visible side by side, 100 is black against white.",
     "CIE 1976", 25.0f},
    {Metric::flip, "flip", "FLIP", "FLIP",
     "Mean difference that is seen when flipping between the pictures at 67 pixels per degree, in [0, 1]: it compares "
     "colours as the eye blurs them, and counts different edges and points more.",
     "Andersson et al. 2020", 1.0f}};

double pixel_rmse(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) / std::sqrt(3.0);
}

double pixel_delta_e(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(lab_of_linear(glm::clamp(a, 0.0, 1.0)), lab_of_linear(glm::clamp(b, 0.0, 1.0)));
}

}  // namespace

std::span<const MetricRow> metrics() {
    return ROWS;
}

const MetricRow& require_metric(std::string_view key) {
    std::string keys;
    for (const MetricRow& row : ROWS) {
        if (key == row.key) return row;
        keys += fmt::format("{}{}", keys.empty() ? "" : ", ", row.key);
    }
    throw Error(fmt::format("There is no metric '{}'; use one of {}.", key, keys));
}

std::vector<float> difference_map(const Image& reference, const Image& test, Metric metric,
                                  const std::stop_token& stop) {
    assert(reference.width == test.width && reference.height == test.height);
    if (metric == Metric::flip) return flip_map(reference, test, stop);
    const auto difference = metric == Metric::rmse ? pixel_rmse : pixel_delta_e;
    std::vector<float> map;
    map.reserve(reference.pixels.size());
    const auto width = static_cast<std::size_t>(reference.width);
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        if (i % width == 0 && stop.stop_requested()) return {};
        map.push_back(
            static_cast<float>(difference(glm::dvec3(reference.pixels[i]), glm::dvec3(test.pixels[i]))));
    }
    return map;
}

double mean_difference(std::span<const float> map, Metric metric) {
    double sum = 0;
    for (const float value : map) {
        const double one = static_cast<double>(value);
        sum += metric == Metric::rmse ? one * one : one;
    }
    const double mean = sum / static_cast<double>(std::max<std::size_t>(map.size(), 1));
    return metric == Metric::rmse ? std::sqrt(mean) : mean;
}

std::vector<float> part_of(std::span<const float> map, int width, const PixelRegion& region) {
    std::vector<float> part;
    for (int y = region.y; y < region.y + region.height; ++y) {
        const auto row = map.subspan(static_cast<std::size_t>(y * width + region.x),
                                     static_cast<std::size_t>(region.width));
        part.insert(part.end(), row.begin(), row.end());
    }
    return part;
}

}  // namespace momentscope
