#include "core/chart/chart_row.hpp"

#include <algorithm>
#include <cassert>

namespace momentscope {

namespace {

// The quantile, interpolated linearly between the two nearest values.
double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    return {quantile(values, 0.5), quantile(values, 0.75) - quantile(values, 0.25)};
}

}  // namespace momentscope
