// series.hpp -- the registry of what the plot can draw: legend, shortcuts, sessions and colours follow from
// it.
#pragma once
#include <span>

#include "core/techniques/technique.hpp"
#include "ui/state.hpp"
#include "ui/theme.hpp"

namespace momentscope::ui {

struct SeriesRow {
    Series id;
    const char* key;       // sessions, event files
    const char* shortcut;  // shows or hides it
    const char* name;
    const char* name_without_bounds;  // for techniques whose beta = 0 and 1 are no bounds; null: the same
    const char* help;
    const char* help_without_bounds;
    ImU32 Palette::*color;
};

/// All series, in the order of Series, which is that of the legend.
std::span<const SeriesRow> series_rows();

/// Does the technique have it?
bool has_series(Series series, const Technique& technique);
const char* series_name(const SeriesRow& row, const Technique& technique);
const char* series_help(const SeriesRow& row, const Technique& technique);

}  // namespace momentscope::ui
