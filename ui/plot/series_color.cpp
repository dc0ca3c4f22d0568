#include "ui/plot/series_color.hpp"

namespace momentscope::ui {

ImU32 series_color(Series series, const Palette& colors) {
    switch (series) {
        case Series::truth:
            return colors.truth;
        case Series::reconstruction:
            return colors.reconstruction;
        case Series::bounds:
            return colors.bounds;
        case Series::sharp:
            return colors.sharp;
        case Series::unbiased_exact:
            return colors.unbiased_exact;
        case Series::stems:
            return colors.stems;
        case Series::errors:
            return colors.errors;
        case Series::wrapping_zone:
            return colors.wrapping_zone;
    }
    return colors.text;
}

}  // namespace momentscope::ui
