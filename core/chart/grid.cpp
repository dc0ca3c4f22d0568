#include "core/chart/grid.hpp"

#include <algorithm>

namespace momentscope {

namespace {

// Configurations in addition to every technique with its default values. For moment-based techniques: the
// effect of the robust bias for techniques with a strong bias in Table 1, the time of the algorithms as
// published, and trigonometric moments without the memory of a stored factor. For Moment Transparency: the
// ways to make it faster that are timed in its Table 1, and the second pass of moments.
constexpr const char* VARIATIONS[] = {
    "power6-32:preset=robust",
    "power8-32:preset=robust",
    "trig4-32:preset=robust",
    "power8-16:preset=robust",
    "trig3-16:preset=robust",
    "power4-32:solver=textbook",
    "power6-32:solver=textbook",
    "power8-32:solver=textbook",
    "trig2-32:solver=textbook",
    "trig3-32:solver=textbook",
    "trig4-32:solver=textbook",
    "trig2-32:factorisation=per-fragment",
    "trig3-32:factorisation=per-fragment",
    "trig4-32:factorisation=per-fragment",
    "power6-32:accumulation=ordered",
    "trig3-32:theta=0.1",
    "wboit:weight=view-depth",
    "wboit:weight=g3d",
    "fourier:coefficients=15",
    "fourier:coefficients=15,lanczos=1",
    "mt:resolution=half",
    "mt:resolution=quarter",
    "mt:resolution=eighth",
    "mt:read-format=theta16",
    "mt:read-format=nlqm64",
    "mt:read-format=nlqm32",
    "mt:resolution=quarter,read-format=theta16",
    "mt:beta=0,moment-passes=opacity",
    "mt:beta=0,moment-passes=visibility",
    "stochastic:pixel-samples=4",
    "stochastic:pixel-samples=16",
    "stochastic:pixel-samples=32",
    "at:nodes=2",
    "at:nodes=8",
    "mlab:layers=2",
    "mlab:layers=6",
    "mlab:layer-bits=8",
    "mlab:layer-bits=32",
};

}  // namespace

std::vector<Configuration> chart_grid(const Technique& technique, const ParameterValues& base) {
    std::vector<Configuration> grid = {{&technique, base}};
    std::vector<std::string> texts = {configuration_text(grid.front())};
    for (const std::string_view text : VARIATIONS) {
        if (text.substr(0, text.find(':')) != technique.id) continue;
        const Configuration varied = parse_configuration(text, base);
        const std::string own = configuration_text(varied);
        if (std::ranges::find(texts, own) != texts.end()) continue;  // already in the grid
        grid.push_back(varied);
        texts.push_back(own);
    }
    return grid;
}

std::vector<Configuration> chart_grid(const ParameterValues& base) {
    std::vector<Configuration> all;
    for (const Technique& technique : techniques()) {
        const auto grid = chart_grid(technique, base);
        all.insert(all.end(), grid.begin(), grid.end());
    }
    return all;
}

}  // namespace momentscope
