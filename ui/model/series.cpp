#include "ui/model/series.hpp"

namespace momentscope::ui {

namespace {

constexpr SeriesRow ROWS[] = {
    {Series::truth, "truth", "U", "truth", nullptr,
     "The true absorbance A(z): the sum of the absorbances of all fragments in front of z. It has a step at every fragment.",
     nullptr},
    {Series::reconstruction, "reconstruction", "K", "reconstruction", nullptr,
     "A(z, b, β): what the technique reconstructs from the moments. Its value at a fragment's own depth determines the "
     "weight of that fragment in the picture.",
     nullptr},
    {Series::bounds, "bounds", "B", "lower, upper bound", "β = 0, β = 1 (no bounds)",
     "The least and the greatest absorbance in front of z that any distribution with the biased moments can have (β = 0 "
     "and β = 1).",
     "The results for β = 0 and β = 1. For trigonometric moments these are not bounds: the truth may lie outside."},
    {Series::sharp, "sharp", "S", "sharp bounds", nullptr,
     "The least and the greatest absorbance in front of z that a distribution on the depth range with the exact moments, "
     "without bias, can have. The truth is never outside. The wider the gap, the less the moments say.",
     nullptr},
    {Series::unbiased_exact, "ghost", "X", "exact, no bias", nullptr,
     "The unbiased exact curve: the reconstruction without moment bias, computed with at least 64 bits. Its distance to the "
     "orange curve is the price of bias and rounding.",
     nullptr},
    {Series::stems, "stems", "C", "canonical masses", nullptr,
     "The canonical representation: masses with the biased moments, one of them at the query depth (diamond). "
     "Stems with full heads count as in front of the query depth. In a plot of T a stem's height is its share of b₀.",
     nullptr},
    {Series::errors, "errors", "E", "error at own depth", nullptr,
     "A line from the truth to the reconstruction at every fragment's own depth: only these values reach the picture.",
     nullptr},
    {Series::wrapping_zone, "wrapping_zone", "Z", "wrapping zone θ", nullptr,
     "The arc of angle θ on the unit circle that holds no depths. It lies beyond the far end of the depth range, where "
     "roots wrap to the near end (Eq. 6).",
     nullptr}};
static_assert(std::size(ROWS) == SERIES_COUNT);

}  // namespace

std::span<const SeriesRow> series_rows() {
    return ROWS;
}

bool has_series(Series series, const Technique& technique) {
    if (series == Series::truth) return true;
    if (series == Series::wrapping_zone) return technique.uses(ParameterId::theta);
    if (series == Series::errors)
        return !technique.is_truth() || technique.truth().way != GroundTruth::Way::sorting;
    return series == Series::reconstruction ? has_function(technique) : technique.has_moments();
}

const char* series_name(const SeriesRow& row, const Technique& technique) {
    return technique.has_bounds() || row.name_without_bounds == nullptr ? row.name : row.name_without_bounds;
}

const char* series_help(const SeriesRow& row, const Technique& technique) {
    return technique.has_bounds() || row.help_without_bounds == nullptr ? row.help : row.help_without_bounds;
}

}  // namespace momentscope::ui
