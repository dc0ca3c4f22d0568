// plot_notes.hpp -- sentences above the plot about what is wrong with the curves.
#pragma once
#include <string>

#include "ui/model/measurement.hpp"

namespace momentscope::ui {

/// One sentence about where and why the truth leaves the band; empty if it does not.
std::string band_note(const Measurement& measurement);

/// Why the solver fails at some depths; "" if it does not fail.
std::string failure_note(const Measurement& measurement);

}  // namespace momentscope::ui
