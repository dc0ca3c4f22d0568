// grid.hpp -- lists the configurations that a chart shows.
#pragma once
#include <span>
#include <vector>

#include "core/techniques/configuration.hpp"

namespace momentscope {

/// The technique with the values in `base`, and then with those values of its own parameters that change its
/// time or its error.
std::vector<Configuration> chart_grid(const Technique& technique, const ParameterValues& base = {});

/// The configurations of all techniques, in the order of the registry.
std::vector<Configuration> chart_grid(const ParameterValues& base = {});

}  // namespace momentscope
