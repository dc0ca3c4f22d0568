// series.hpp -- the registry of the series that the plot can draw. Legend, shortcuts and sessions are
// built from it.
#pragma once
#include <span>

#include "core/techniques/technique.hpp"
#include "ui/model/state.hpp"

namespace momentscope::ui {

struct SeriesRow {
    Series id;
    const char* key;       // in sessions and event files
    const char* shortcut;  // shows or hides the series
    const char* name;
    const char* name_without_bounds;  // if beta = 0 and beta = 1 are not bounds; null: the same name
    const char* help;
    const char* help_without_bounds;
};

/// All series in the order of the enum Series, which is the order of the legend.
std::span<const SeriesRow> series_rows();

/// Does the technique have this series?
bool has_series(Series series, const Technique& technique);
const char* series_name(const SeriesRow& row, const Technique& technique);
const char* series_help(const SeriesRow& row, const Technique& technique);

}  // namespace momentscope::ui
