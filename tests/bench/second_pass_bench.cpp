// second_pass_bench.cpp -- measures the milliseconds of the second pass in interleaved rounds of one run, on
// teapots and ship: with the textbook solver, and with the robust solver, which factors for each fragment or
// once per pixel. The time includes the pass that factors between the first and the second pass.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "app/gl_context.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/scenes.hpp"
#include "tests/bench/bench.hpp"

namespace momentscope {
namespace {

struct Row {
    const Technique* technique;
    std::vector<double> milliseconds[3]{};  // in the order of WAYS
};

enum class Way { textbook, per_fragment, per_pixel };
constexpr Way WAYS[] = {Way::textbook, Way::per_fragment, Way::per_pixel};

bool can(const Row& row, Way way) {
    return way != Way::textbook || row.technique->uses(ParameterId::solver);
}

/// One round of all ways. The bias changes by a ten-thousandth in every round, so that no result of the last
/// round can be reused.
void run_round(Renderer& renderer, const Scene& scene, std::vector<Row>& rows, int round) {
    for (Row& row : rows)
        for (const Way way : WAYS) {
            if (!can(row, way)) continue;
            ParameterValues values;
            values.set(ParameterId::alpha,
                       automatic_bias(values, *row.technique) * (1.0f + 1.0e-4f * static_cast<float>(round)));
            values.set(way == Way::textbook ? Solver::textbook : Solver::robust);
            values.set(way == Way::per_fragment ? Factorisation::per_fragment : Factorisation::per_pixel);
            // Draw twice, because a new way creates its textures and programs first.
            renderer.render({scene.camera, BENCH_SIZE, row.technique, values});
            values.set(ParameterId::alpha, *values[ParameterId::alpha] * 1.00005f);
            renderer.render({scene.camera, BENCH_SIZE, row.technique, values});
            if (round > 0) row.milliseconds[static_cast<int>(way)].push_back(renderer.pass_times().color);
        }
}

std::string ratio(double time, double textbook) {
    return textbook > 0 ? fmt::format("{:.2f}", time / textbook) : "-";
}

void run(int rounds, std::string_view only) {
    const auto context = make_headless_context({16, 16});
    Renderer renderer;
    fmt::print(
        "{}\nms of the second pass at {}x{}; in brackets as a share of the textbook solver's\n{:<10}{:<12}{:>10}{:>16}{:>16}\n",
        reinterpret_cast<const char*>(glGetString(GL_RENDERER)), BENCH_SIZE.x, BENCH_SIZE.y, "scene",
        "technique", "textbook", "per fragment", "per pixel");
    for (const char* id : {"teapots", "ship"}) {
        const Scene scene = load_scene(id, BENCH_OPACITY);
        renderer.set_scene(scene);
        std::vector<Row> rows;
        for (const Technique* technique : moment_based_techniques())
            if (technique->uses(ParameterId::factorisation) && is_wanted(only, technique->id))
                rows.push_back({technique});
        for (int round = 0; round <= rounds; ++round) run_round(renderer, scene, rows, round);
        for (const Row& row : rows) {
            double times[3] = {};
            for (const Way way : WAYS)
                if (can(row, way))
                    times[static_cast<int>(way)] = median(row.milliseconds[static_cast<int>(way)]);
            fmt::print("{:<10}{:<12}{:>10.1f}{:>9.1f} ({:>4}){:>9.1f} ({:>4})\n", id, row.technique->id,
                       times[0], times[1], ratio(times[1], times[0]), times[2], ratio(times[2], times[0]));
        }
    }
}

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    return momentscope::bench_main(argc, argv, "second_pass_bench", 9, momentscope::run);
}
