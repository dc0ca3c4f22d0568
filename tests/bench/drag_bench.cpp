// drag_bench.cpp -- measures updates per second while a slider or the camera is dragged over teapots in a
// window of 1280x720, with full pictures and with drafts.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string_view>

#include "app/headless_window.hpp"
#include "tests/bench/bench.hpp"

namespace momentscope {
namespace {

void point(ImVec2 at, int button, bool down) {
    ImGui::GetIO().MousePos = at;
    ImGui::GetIO().MouseDown[button] = down;
}

struct Drag {
    const char* name;
    const char* anchor;
    int button;
};

/// Mean updates per second over `moves` moves, after some moves that compile shaders and choose the draft's
/// resolution.
double updates_per_second(HeadlessWindow& window, const Drag& drag, int moves) {
    constexpr int WARM_UP = 6;
    const ui::Rect rect = window.explorer().workspace().widget_rects.at(drag.anchor);
    const auto at = [&](int move) {
        const float share = 0.2f + 0.6f * static_cast<float>(move) / static_cast<float>(moves + WARM_UP);
        return ImVec2(rect.low.x + share * (rect.high.x - rect.low.x), 0.5f * (rect.low.y + rect.high.y));
    };
    point(at(0), drag.button, false);
    window.draw();
    point(at(0), drag.button, true);
    window.draw();
    auto begin = std::chrono::steady_clock::now();
    for (int move = 1; move <= moves + WARM_UP; ++move) {
        if (move == WARM_UP + 1) begin = std::chrono::steady_clock::now();
        point(at(move), drag.button, true);
        window.draw();
        window.pixels();
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    point({-10, -10}, drag.button, false);
    window.settle();
    return moves / took.count();
}

void run(int moves, std::string_view only) {
    fmt::print("{:<12}{:<12}{:>16}{:>16}\n", "technique", "drag", "full picture", "draft");
    for (const Technique* technique : moment_based_techniques()) {
        if (technique->moment_kernel().bits != 32 || !is_wanted(only, technique->id)) continue;
        for (const Drag& drag : {Drag{"beta", "parameter.beta", 0}, Drag{"camera", "scene", 1}}) {
            double rates[2];
            for (const bool draft : {false, true}) {
                FrameLog log("");
                ui::ExplorerState state;
                state.scene = "teapots";
                state.technique = technique;
                HeadlessWindow window({1280, 720}, state,
                                      {.scale = 1,
                                       .show_times = false,
                                       .most_milliseconds = draft ? ui::DRAG_MILLISECONDS
                                                                  : std::numeric_limits<double>::infinity()},
                                      log);
                window.settle();
                rates[draft] = updates_per_second(window, drag, moves);
            }
            fmt::print("{:<12}{:<12}{:>14.1f}/s{:>14.1f}/s\n", technique->id, drag.name, rates[0], rates[1]);
            std::fflush(stdout);
        }
    }
}

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    return momentscope::bench_main(argc, argv, "drag_bench", 20, momentscope::run);
}
