// chart_row.hpp -- what a chart knows of one configuration on one scene.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace momentscope {

/// Milliseconds of several repeats. range: from the lower to the upper quartile.
struct Spread {
    double median = 0, range = 0;
    friend bool operator==(const Spread&, const Spread&) = default;
};

/// Of at least one number.
Spread spread_of(std::vector<double> values);

struct ChartNumbers {
    Spread moments, color, composite;     // the passes of the technique
    Spread total;                         // of the three
    Spread differential;                  // total minus that of plain alpha blending in the same round
    std::optional<int> stored_bits;       // per pixel, beside the colour buffers, and with the factor that is
    std::optional<int> bits_with_factor;  // stored once per pixel; nullopt where they grow with the fragments
    std::optional<int> geometry_passes;   // nullopt where they grow with the layers
    double rmse = 0, delta_e = 0, flip = 0;  // against `sorted`
    double stability = 0;  // the greatest change of the rmse from one picture of the camera path to the next
    friend bool operator==(const ChartNumbers&, const ChartNumbers&) = default;
};

struct ChartRow {
    std::string scene;
    std::string configuration;            // configuration_text
    std::string unavailable;              // why there are no numbers, as a sentence
    std::optional<ChartNumbers> numbers;  // or these
    friend bool operator==(const ChartRow&, const ChartRow&) = default;
};

}  // namespace momentscope
