// second_pass_bench.cpp -- what it saves to factor once per pixel: milliseconds of the second pass both ways,
// with the pass between included, in interleaved rounds of one run, on teapots and ship.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <vector>

#include "app/gl_context.hpp"
#include "core/error.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/scenes.hpp"

namespace momentscope {
namespace {

constexpr glm::ivec2 SIZE(640, 360);
constexpr float OPACITY = 0.4f;  // of mesh files; built-in scenes do not ask

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Row {
    const Technique* technique;
    std::vector<double> per_fragment{}, per_pixel{};  // milliseconds
};

/// One round of all. Bias differs from round to round by a ten-thousandth, so that nothing that the last one
/// made can be kept.
void run_round(Renderer& renderer, const Scene& scene, std::vector<Row>& rows, int round) {
    for (Row& row : rows)
        for (const bool once : {false, true}) {
            ParameterValues values;
            values.set(ParameterId::alpha,
                       automatic_bias(values, *row.technique) * (1.0f + 1.0e-4f * static_cast<float>(round)));
            values.set(ParameterId::factorisation, once ? 0.0f : 1.0f);
            renderer.render({scene.camera, SIZE, row.technique, values});
            if (round > 0) (once ? row.per_pixel : row.per_fragment).push_back(renderer.pass_times().color);
        }
}

void run(int rounds, std::string_view only) {
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    fmt::print("{}\n{:<10}{:<12}{:>14}{:>12}{:>8}\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
               "scene", "technique", "per fragment", "per pixel", "ratio");
    for (const char* id : {"teapots", "ship"}) {
        const Scene scene = load_scene(id, OPACITY);
        renderer.set_scene(scene);
        std::vector<Row> rows;
        for (const Technique* technique : moment_based_techniques())
            if (technique->uses(ParameterId::factorisation) &&
                (only.empty() || only.find(technique->id) != only.npos))
                rows.push_back({technique});
        for (int round = 0; round <= rounds; ++round) run_round(renderer, scene, rows, round);
        for (const Row& row : rows)
            fmt::print("{:<10}{:<12}{:>11.1f} ms{:>9.1f} ms{:>8.2f}\n", id, row.technique->id,
                       median(row.per_fragment), median(row.per_pixel),
                       median(row.per_pixel) / median(row.per_fragment));
    }
}

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    int rounds = 9;  // the first argument; the second lists techniques
    if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), rounds);
    try {
        momentscope::run(std::max(rounds, 1), argc > 2 ? argv[2] : "");
    } catch (const momentscope::Error& error) {
        std::fputs(fmt::format("second_pass_bench: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
}
