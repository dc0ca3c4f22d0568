#include "core/bench/shadow_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/compare/difference.hpp"
#include "core/scene/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/markup.hpp"

namespace momentscope {

namespace {

constexpr const char* VIEWED_BY = "power6-32";  // the technique of the eye, as in the paper, in floats

ParameterValues values_of(const ShadowChartSettings& settings, const std::string& technique, int map_size) {
    ParameterValues values = settings.values;
    values.turn(ParameterId::shadows, true);
    values.set(ParameterId::shadow_size, static_cast<float>(map_size));
    const Parameter& row = parameter(ParameterId::shadow_technique);
    values.set(row.id, parse_parameter(row, technique));
    return values;
}

double shade_time(const PassTimes& times) {
    return times.opaque + times.color + times.composite;
}

/// The times of all rounds of one row.
struct Rounds {
    std::vector<double> render, filter, shade, differential;
};

/// Measures a scene at one map size.
class ShadowBench {
public:
    ShadowBench(Renderer& renderer, const Scene& scene, const ShadowChartSettings& settings, int map_size)
        : renderer_(renderer), scene_(scene), settings_(settings), map_size_(map_size) {}

    void round(std::vector<Rounds>& all, bool counts) {
        // Only opaque casters. Their map stays, and transparent casters are left out.
        show(values_of(settings_, "none", map_size_));
        const double alone = shade_time(renderer_.pass_times());
        for (std::size_t i = 0; i < settings_.techniques.size(); ++i) {
            show(values_of(settings_, settings_.techniques[i], map_size_));
            if (!counts) continue;
            const ShadowStages& maps = renderer_.shadow_maps()->stages();
            const double shade = shade_time(renderer_.pass_times());
            all[i].render.push_back(maps.transparent_render.milliseconds);
            all[i].filter.push_back(maps.transparent_filter.milliseconds);
            all[i].shade.push_back(shade);
            all[i].differential.push_back(maps.transparent_render.milliseconds +
                                          maps.transparent_filter.milliseconds + shade - alone);
        }
    }

    std::optional<Image> deep_picture() {
        try {
            show(values_of(settings_, "deep", map_size_));
        } catch (const Error&) {
            return std::nullopt;
        }
        return renderer_.read_picture();
    }

    Image picture(const std::string& technique) {
        show(values_of(settings_, technique, map_size_));
        return renderer_.read_picture();
    }

private:
    void show(const ParameterValues& values) {
        renderer_.render({scene_.camera, settings_.size, &require_technique(VIEWED_BY), values});
    }

    Renderer& renderer_;
    const Scene& scene_;
    const ShadowChartSettings& settings_;
    int map_size_;
};

ShadowRow row_of(const std::string& scene, const std::string& technique, int map_size,
                 const ShadowChartSettings& settings, const Rounds& rounds) {
    return {
        .scene = scene,
        .technique = technique,
        .map_size = map_size,
        .bits_per_texel = 32 * texel_numbers(light_configuration(values_of(settings, technique, map_size))),
        .render = spread_of(rounds.render),
        .filter = spread_of(rounds.filter),
        .shade = spread_of(rounds.shade),
        .differential = spread_of(rounds.differential),
        .rmse = {}};
}

}  // namespace

std::vector<ShadowRow> measure_shadows(const Scene& scene, const ShadowChartSettings& settings,
                                       const std::stop_token& stop,
                                       const std::function<void(std::size_t, std::size_t)>& progress) {
    Renderer renderer;
    renderer.set_scene(scene);
    const auto rounds = static_cast<std::size_t>(settings.repeat) + 2;  // one to link shaders, one for errors
    const std::size_t all = rounds * settings.map_sizes.size();
    std::size_t done = 0;
    std::vector<ShadowRow> rows;
    for (const int map_size : settings.map_sizes) {
        ShadowBench bench(renderer, scene, settings, map_size);
        std::vector<Rounds> times(settings.techniques.size());
        for (int round = 0; round <= settings.repeat; ++round) {
            if (stop.stop_requested()) return {};
            bench.round(times, round > 0);
            progress(++done, all);
        }
        const std::optional<Image> deep = bench.deep_picture();
        for (std::size_t i = 0; i < times.size(); ++i) {
            rows.push_back(row_of(scene.id, settings.techniques[i], map_size, settings, times[i]));
            if (deep)
                rows.back().rmse =
                    mean_difference(*deep, bench.picture(settings.techniques[i]), Metric::rmse);
        }
        progress(++done, all);
    }
    return rows;
}

std::string shadow_rows_to_csv(const std::vector<ShadowRow>& rows) {
    std::string text =
        "scene,technique,map_size,bits_per_texel,render_ms,render_spread,filter_ms,filter_spread,shade_ms,shade_spread,"
        "differential_ms,differential_spread,rmse\n";
    for (const ShadowRow& row : rows) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{}", csv_field(row.scene), row.technique,
                       row.map_size, row.bits_per_texel);
        for (const Spread& spread : {row.render, row.filter, row.shade, row.differential})
            fmt::format_to(std::back_inserter(text), ",{:.3f},{:.3f}", spread.median, spread.range);
        text += row.rmse ? fmt::format(",{:.6f}\n", *row.rmse) : ",\n";
    }
    return text;
}

std::string shadow_rows_to_markdown(const std::vector<ShadowRow>& rows) {
    std::string text =
        "| scene | map | technique | bits per texel | render | filter | shade | differential | to fourier-7 | RMSE |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const ShadowRow& row : rows) {
        const auto fourier = std::ranges::find_if(rows, [&](const ShadowRow& r) {
            return r.scene == row.scene && r.map_size == row.map_size && r.technique == "fourier-7";
        });
        const auto cell = [](const Spread& s) {
            return fmt::format("{:.{}f} ± {:.{}f}", s.median, s.median < 10 ? 1 : 0, 0.5 * s.range,
                               s.median < 10 ? 1 : 0);
        };
        fmt::format_to(std::back_inserter(text),
                       "| {0} | {1}² | {2} | {3} | {4} | {5} | {6} | {7} | {8} | {9} |\n",
                       markdown_cell(row.scene), row.map_size, row.technique, row.bits_per_texel,
                       cell(row.render), cell(row.filter), cell(row.shade), cell(row.differential),
                       fourier == rows.end()
                           ? "–"
                           : fmt::format("{:.2f}", row.differential.median / fourier->differential.median),
                       row.rmse ? fmt::format("{:.4f}", *row.rmse) : "–");
    }
    return text;
}

}  // namespace momentscope
