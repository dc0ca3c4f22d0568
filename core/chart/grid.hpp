// grid.hpp -- which configurations of which techniques a chart shows.
#pragma once
#include <span>
#include <vector>

#include "core/techniques/configuration.hpp"

namespace momentscope {

/// The technique as `base` has it, and then with the values of its own parameters that make a difference to
/// its time or its error.
std::vector<Configuration> chart_grid(const Technique& technique, const ParameterValues& base = {});

/// Those of all techniques, in the order of the registry.
std::vector<Configuration> chart_grid(const ParameterValues& base = {});

}  // namespace momentscope
