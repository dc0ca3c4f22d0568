// second_pass_bench.cpp -- milliseconds of the second pass in interleaved rounds of one run, on teapots and
// ship: by the textbook solver, and by the robust one that factors for each fragment or once per pixel, with
// the pass between included.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "app/gl_context.hpp"
#include "core/error.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/scenes.hpp"

namespace momentscope {
namespace {

constexpr glm::ivec2 SIZE(1280, 720);
constexpr float OPACITY = 0.4f;  // of mesh files; built-in scenes do not ask

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Row {
    const Technique* technique;
    std::vector<double> milliseconds[3]{};  // in the order of WAYS
};

enum class Way { textbook, per_fragment, per_pixel };
constexpr Way WAYS[] = {Way::textbook, Way::per_fragment, Way::per_pixel};

bool can(const Row& row, Way way) {
    return way != Way::textbook || row.technique->kernel->has_textbook;
}

/// One round of all. Bias differs from round to round by a ten-thousandth, so that nothing that the last one
/// made can be kept.
void run_round(Renderer& renderer, const Scene& scene, std::vector<Row>& rows, int round) {
    for (Row& row : rows)
        for (const Way way : WAYS) {
            if (!can(row, way)) continue;
            ParameterValues values;
            values.set(ParameterId::alpha,
                       automatic_bias(values, *row.technique) * (1.0f + 1.0e-4f * static_cast<float>(round)));
            values.set(ParameterId::solver, way == Way::textbook ? 1.0f : 0.0f);
            values.set(ParameterId::factorisation, way == Way::per_fragment ? 1.0f : 0.0f);
            // Twice, because a way that is new makes its textures and programs first.
            renderer.render({scene.camera, SIZE, row.technique, values});
            values.set(ParameterId::alpha, *values[ParameterId::alpha] * 1.00005f);
            renderer.render({scene.camera, SIZE, row.technique, values});
            if (round > 0) row.milliseconds[static_cast<int>(way)].push_back(renderer.pass_times().color);
        }
}

std::string ratio(double time, double textbook) {
    return textbook > 0 ? fmt::format("{:.2f}", time / textbook) : "-";
}

void run(int rounds, std::string_view only) {
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    fmt::print(
        "{}\nms of the second pass at {}x{}; in brackets as a share of the textbook solver's\n{:<10}{:<12}{:>10}{:>16}{:>16}\n",
        reinterpret_cast<const char*>(glGetString(GL_RENDERER)), SIZE.x, SIZE.y, "scene", "technique",
        "textbook", "per fragment", "per pixel");
    for (const char* id : {"teapots", "ship"}) {
        const Scene scene = load_scene(id, OPACITY);
        renderer.set_scene(scene);
        std::vector<Row> rows;
        for (const Technique* technique : moment_based_techniques())
            if (technique->uses(ParameterId::factorisation) &&
                (only.empty() || only.find(technique->id) != only.npos))
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
    int rounds = 9;  // the first argument; the second lists techniques
    if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), rounds);
    try {
        momentscope::run(std::max(rounds, 1), argc > 2 ? argv[2] : "");
    } catch (const momentscope::Error& error) {
        std::fputs(fmt::format("second_pass_bench: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
}
