// difference.hpp -- how far one picture is from another, per pixel and in all.
#pragma once
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

enum class Metric { rmse, delta_e, flip };
constexpr std::size_t METRIC_COUNT = 3;

/// One row, in the order of Metric: everything that is said about a metric anywhere.
struct MetricRow {
    Metric id;
    const char* key;
    const char* name;
    const char* symbol;  // short, for labels
    const char* help;    // what it means, its range, and how pixels become one number
    const char* source;
    float full_scale;  // where the colours of a map end
};
std::span<const MetricRow> metrics();

/// Throws Error that lists the keys.
const MetricRow& require_metric(std::string_view key);

/// Differences of all pixels, row by row. Both pictures are linear RGB of the same size; what leaves [0, 1]
/// is clamped for delta_e and flip, which judge what a display shows. rmse: root of the mean square of the
/// three channels. delta_e: distance in CIELAB (1976, D65). flip: LDR-FLIP at 67 pixels per degree, in [0,
/// 1]. Empty when it was stopped.
std::vector<float> difference_map(const Image& reference, const Image& test, Metric metric,
                                  const std::stop_token& stop = {});

/// Of a map: its root mean square for rmse, its mean for the others.
double mean_difference(std::span<const float> map, Metric metric);

/// A rectangle of pixels; x, y is its upper left.
struct PixelRegion {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(glm::ivec2 pixel) const {
        return pixel.x >= x && pixel.y >= y && pixel.x < x + width && pixel.y < y + height;
    }
    friend bool operator==(const PixelRegion&, const PixelRegion&) = default;
};

/// The part of a map of that width that lies in the region, which must lie in the map.
std::vector<float> part_of(std::span<const float> map, int width, const PixelRegion& region);

/// Of the whole pictures. Means nothing when it was stopped.
inline double mean_difference(const Image& reference, const Image& test, Metric metric,
                              const std::stop_token& stop = {}) {
    return mean_difference(difference_map(reference, test, metric, stop), metric);
}

}  // namespace momentscope
