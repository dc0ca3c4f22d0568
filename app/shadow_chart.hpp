// shadow_chart.hpp -- chart --shadows: the cost of shadows of transparent casters (Table 2 of the paper).
#pragma once
#include <string>
#include <vector>

#include "app/options.hpp"

namespace momentscope {

/// The options of `chart` that it reads.
struct ShadowChartOptions {
    std::vector<std::string> scenes;
    glm::ivec2 size;
    int rounds;
    const ParameterOptions& parameters;
    std::string output;  // .csv, .md, or empty for standard output
};

/// Throws Error.
void run_shadow_chart(const ShadowChartOptions& options);

}  // namespace momentscope
