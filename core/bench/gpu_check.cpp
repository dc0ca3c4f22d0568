#include "core/bench/gpu_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/inspect/pixel_color.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 CHECKED_SIZE = {48, 27}, TIMED_SIZE = {480, 270};

// The greater of two errors. One that is not finite is the greatest.
double worse(double a, double b) {
    if (!std::isfinite(a)) return a;
    return !std::isfinite(b) ? b : std::max(a, b);
}

// Compares each pixel with what C++ makes of its captured fragments.
void compare_pixels(Renderer& renderer, TechniqueCheck& check) {
    const Technique& technique = *check.technique;
    const ResolvedParameters parameters = resolve({}, technique);
    const std::vector<PixelCapture> captures = renderer.capture_region({0, 0}, CHECKED_SIZE);
    const Image picture = renderer.read_picture();
    for (std::size_t i = 0; i < captures.size(); ++i) {
        const PixelCapture& capture = captures[i];
        const auto rows = pixel_history(capture.ray, capture.transmittance, technique, {});
        for (const PixelHistoryRow& row : rows) {
            if (!row.gl_transmittance) continue;
            ++check.fragments;
            const float cpp = row.transmittance, gl = *row.gl_transmittance;
            if (std::bit_cast<std::uint32_t>(cpp) != std::bit_cast<std::uint32_t>(gl)) ++check.different;
            check.worst = worse(check.worst, std::abs(static_cast<double>(cpp) - static_cast<double>(gl)));
        }
        const PixelColors colors = pixel_colors(capture.ray, rows, technique, parameters, capture.behind);
        const glm::vec3 expected = technique.is_truth() ? colors.truth : colors.technique;
        const glm::vec3 off = glm::abs(expected - glm::vec3(picture.pixels[i]));
        for (int k = 0; k < 3; ++k)
            check.picture_error = worse(check.picture_error, static_cast<double>(off[k]));
    }
}

void check_technique(Renderer& renderer, const Scene& scene, TechniqueCheck& check) {
    check.why_not = why_unavailable(*check.technique, renderer.gl());
    if (!check.why_not.empty()) {
        check.state = CheckState::unavailable;
        return;
    }
    try {
        renderer.render({scene.camera, CHECKED_SIZE, check.technique, {}});
        compare_pixels(renderer, check);
        if (check.technique->is_truth()) return;  // its speed does not matter
        renderer.render({scene.camera, TIMED_SIZE, check.technique, {}});
        renderer.redraw();  // the first picture waits for memory and compilers
        check.first_pass = renderer.pass_times().moments;
        check.second_pass = renderer.pass_times().color;
    } catch (const Error& error) {
        check.state = CheckState::failed;
        check.why_not = error.what();
    }
}

}  // namespace

TechniqueCheck GpuCheck::sum() const {
    TechniqueCheck all;
    for (const TechniqueCheck& row : techniques) {
        if (row.state != CheckState::checked) continue;
        all.fragments += row.fragments;
        all.different += row.different;
        all.worst = worse(all.worst, row.worst);
        all.picture_error = worse(all.picture_error, row.picture_error);
    }
    return all;
}

long GpuCheck::count(CheckState state) const {
    return std::ranges::count(techniques, state, &TechniqueCheck::state);
}

bool GpuCheck::passed() const {
    return count(CheckState::failed) == 0 && has_same_bits() && sum().picture_error <= PICTURE_TOLERANCE;
}

GpuCheckPlan full_gpu_check() {
    GpuCheckPlan plan;
    for (const Technique& technique : techniques()) plan.techniques.push_back(&technique);
    return plan;
}

GpuCheck check_gpu(const GpuCheckPlan& plan, const std::shared_ptr<ProgramCache>& programs,
                   const std::stop_token& stop, const std::function<void()>& step) {
    const Clock::time_point begin = Clock::now();
    GpuCheck check;
    check.gl = gl_info(programs->gl());
    const Scene scene = load_scene("teapots", 0.4f);
    Renderer renderer(programs);
    renderer.set_scene(scene);
    for (const Technique* technique : plan.techniques) {
        if (stop.stop_requested()) break;
        TechniqueCheck& row = check.techniques.emplace_back();
        row.technique = technique;
        if (Clock::now() - begin < plan.limit) {
            check_technique(renderer, scene, row);
        } else {
            row.state = CheckState::not_reached;
            row.why_not = "The time was over; give --seconds more.";
        }
        step();
    }
    check.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return check;
}

}  // namespace momentscope
