// difference.hpp -- how far one picture is from another, per pixel and in all.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

enum class Metric { rmse, delta_e, flip };

/// One row: everything that is said about a metric anywhere.
struct MetricRow {
    Metric id;
    const char* key;
    const char* name;
    const char* help;  // what it means, its range, and how pixels become one number
    const char* source;
    float full_scale;  // where the colours of a map end
};
std::span<const MetricRow> metrics();

/// Throws Error that lists the keys.
const MetricRow& require_metric(std::string_view key);

/// Differences of all pixels, row by row. Both pictures are linear RGB of the same size; what leaves [0, 1]
/// is clamped for delta_e and flip, which judge what a display shows. rmse: root of the mean square of the
/// three channels. delta_e: distance in CIELAB (1976, D65). flip: LDR-FLIP at 67 pixels per degree, in [0,
/// 1].
std::vector<float> difference_map(const Image& reference, const Image& test, Metric metric);

/// Of a map: its root mean square for rmse, its mean for the others.
double mean_difference(std::span<const float> map, Metric metric);

/// Of the whole pictures.
inline double mean_difference(const Image& reference, const Image& test, Metric metric) {
    return mean_difference(difference_map(reference, test, metric), metric);
}

}  // namespace momentscope
