// shadow_chart.hpp -- measures the time of shadows of transparent casters, by technique and map size, as in
// Table 2 of the paper.
#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/render/renderer.hpp"

namespace momentscope {

/// One technique of the map of transparent casters, on one scene, at one map size. Times are in milliseconds.
struct ShadowRow {
    std::string scene;
    std::string technique;  // a choice of ParameterId::shadow_technique
    int map_size = 0;
    int bits_per_texel = 0;
    Spread render;               // drawing the map of transparent casters
    Spread filter;               // filtering this map
    Spread shade;                // the picture: opaque surfaces, second pass and composite
    Spread differential;         // render + filter + shade, minus the time of shade without shadows of
                                 // transparent casters
    std::optional<double> rmse;  // compared with a deep shadow map of this size; nullopt if that is too large
};

struct ShadowChartSettings {
    std::vector<std::string> techniques;  // choices of ParameterId::shadow_technique, not deep
    std::vector<int> map_sizes;
    glm::ivec2 size{640, 360};
    int repeat = 3;  // rounds
    ParameterValues values;
};

/// All rows of a scene. Techniques take turns in each round, so that noise affects all alike. An additional
/// first round links shaders. progress(done, all) counts rounds. Empty if stopped. Throws Error if a map
/// cannot be drawn.
std::vector<ShadowRow> measure_shadows(const Scene& scene, const ShadowChartSettings& settings,
                                       const std::stop_token& stop,
                                       const std::function<void(std::size_t, std::size_t)>& progress);

/// CSV with one line per row and a header.
std::string shadow_rows_to_csv(const std::vector<ShadowRow>& rows);

/// A table like Table 2 of the paper, with the ratio of differential times to that of fourier-7, if it was
/// measured.
std::string shadow_rows_to_markdown(const std::vector<ShadowRow>& rows);

}  // namespace momentscope
