// shadow_chart.hpp -- chart --shadows: what shadows of transparent casters cost (Table 2 of the paper).
#pragma once
#include <string>
#include <vector>

#include "app/options.hpp"

namespace momentscope {

/// What of the options of `chart` it reads.
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
