// difference.hpp -- measures the difference of two pictures, per pixel and in total.
#pragma once
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

enum class Metric { rmse, delta_e, flip };
constexpr std::size_t METRIC_COUNT = 3;

/// One row of the registry, in the order of Metric: everything that the program says about a metric.
struct MetricRow {
    Metric id;
    const char* key;
    const char* name;
    const char* symbol;  // short, for labels
    const char* help;    // its meaning, its range, and how pixels become one number
    const char* source;
    float full_scale;  // value with the last colour of a map
};
std::span<const MetricRow> metrics();

/// The metric with this key. Throws Error, with a list of all keys, if there is none.
const MetricRow& require_metric(std::string_view key);

/// The differences of all pixels, row by row. Both pictures are linear RGB of the same size. delta_e and flip
/// measure what a display shows, so colours are clamped to [0, 1] for them. rmse: root of the mean square of
/// the three channels. delta_e: distance in CIELAB (1976, D65). flip: LDR-FLIP at 67 pixels per degree, in
/// [0, 1]. Empty if stopped.
std::vector<float> difference_map(const Image& reference, const Image& test, Metric metric,
                                  const std::stop_token& stop = {});

/// One number for a map: its root mean square for rmse, its mean for the others.
double mean_difference(std::span<const float> map, Metric metric);

/// A rectangle of pixels. x, y: its upper left.
struct PixelRegion {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(glm::ivec2 pixel) const {
        return pixel.x >= x && pixel.y >= y && pixel.x < x + width && pixel.y < y + height;
    }
    friend bool operator==(const PixelRegion&, const PixelRegion&) = default;
};

/// The part of a map of this width that lies in the region. The region must lie within the map.
std::vector<float> part_of(std::span<const float> map, int width, const PixelRegion& region);

/// One number for two whole pictures. If stopped, the result means nothing.
inline double mean_difference(const Image& reference, const Image& test, Metric metric,
                              const std::stop_token& stop = {}) {
    return mean_difference(difference_map(reference, test, metric, stop), metric);
}

}  // namespace momentscope
