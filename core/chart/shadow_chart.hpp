// shadow_chart.hpp -- what shadows of transparent casters cost, by technique and map size: the paper's
// Table 2.
#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/render/renderer.hpp"

namespace momentscope {

/// One technique of the transparent casters' map on one scene at one map size. Milliseconds of a round each.
struct ShadowRow {
    std::string scene;
    std::string technique;  // a choice of ParameterId::shadow_technique
    int map_size = 0;
    int bits_per_texel = 0;
    Spread render;        // the map of transparent casters
    Spread filter;        // of that map
    Spread shade;         // the picture: opaque surfaces, and the second pass and composite of its technique
    Spread differential;  // render, filter and shade, less what shade takes without shadows of transparent
                          // casters
    std::optional<double>
        rmse;  // against a deep shadow map of that size; nullopt where there is too much to hold
};

struct ShadowChartSettings {
    std::vector<std::string> techniques;  // choices of ParameterId::shadow_technique, not deep
    std::vector<int> map_sizes;
    glm::ivec2 size{640, 360};
    int repeat = 3;  // rounds
    ParameterValues values;
};

/// All rows of a scene, technique by technique in interleaved rounds, so that noise hits all alike; a round
/// that links shaders comes before. progress(done, all) counts rounds. Empty when stopped. Throws Error where
/// a map cannot be drawn.
std::vector<ShadowRow> measure_shadows(const Scene& scene, const ShadowChartSettings& settings,
                                       std::stop_token stop,
                                       const std::function<void(std::size_t, std::size_t)>& progress);

/// One line per row, with a header.
std::string shadow_rows_to_csv(const std::vector<ShadowRow>& rows);

/// The form of the paper's Table 2, with the ratio of differential times to that of fourier-7, where it was
/// measured.
std::string shadow_rows_to_markdown(const std::vector<ShadowRow>& rows);

}  // namespace momentscope
