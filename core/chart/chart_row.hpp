// chart_row.hpp -- the results of a chart for one configuration on one scene.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace momentscope {

/// A time in milliseconds over several repeats. range: from the lower to the upper quartile.
struct Spread {
    double median = 0, range = 0;
    friend bool operator==(const Spread&, const Spread&) = default;
};

/// The spread of at least one number.
Spread spread_of(std::vector<double> values);

struct ChartNumbers {
    Spread moments, color, composite;        // the passes of the technique
    Spread total;                            // of these three
    Spread differential;                     // total minus that of `unsorted` in the same round
    std::optional<int> stored_bits;          // per pixel, without colour buffers; nullopt if they grow
    std::optional<int> bits_with_factor;     // the same with the factor that is stored once per pixel
    std::optional<int> geometry_passes;      // nullopt if they grow with the layers
    double rmse = 0, delta_e = 0, flip = 0;  // against `sorted`
    double stability = 0;  // greatest change of rmse from one picture of the camera path to the next
    friend bool operator==(const ChartNumbers&, const ChartNumbers&) = default;
};

struct ChartRow {
    std::string scene;
    std::string configuration;            // configuration_text
    std::string unavailable;              // a sentence that says why there are no numbers
    std::optional<ChartNumbers> numbers;  // or the numbers
    friend bool operator==(const ChartRow&, const ChartRow&) = default;
};

}  // namespace momentscope
