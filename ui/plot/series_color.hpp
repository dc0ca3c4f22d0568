// series_color.hpp -- the colours of the plot's series.
#pragma once
#include "ui/model/series.hpp"
#include "ui/widgets/theme.hpp"

namespace momentscope::ui {

ImU32 series_color(Series series, const Palette& colors);

}  // namespace momentscope::ui
