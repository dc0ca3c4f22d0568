// failures_test.cpp -- counts fragments of the scenes that fail, in the same way as stress: almost none with
// the bias preset robust, and many pixels with the textbook solver without bias.
#include <fmt/format.h>

#include <cmath>

#include "core/inspect/exact.hpp"
#include "core/stress/stress.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

class Failures : public GlTest<testing::TestWithParam<const Technique*>> {
protected:
    FailureCounts count(const char* scene_id, const ParameterValues& values) {
        const Scene scene = load_scene(scene_id, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        View view = view_of(scene, GetParam()->id, {320, 180});
        view.parameters = values;
        renderer.render(view);
        return renderer.draw_failures().value();
    }
};

TEST_P(Failures, AreNextToNoneOnTheScenesWithTheRobustBias) {
    const Technique& technique = *GetParam();
    if (const std::string why = why_unavailable(technique, shared_programs()->gl()); !why.empty())
        GTEST_SKIP() << why;
    ParameterValues values;
    values.set(BiasPreset::robust);
    const ResolvedParameters parameters = resolve(values, technique);
    using std::abs;
    using std::exp;
    const auto beta = static_cast<Real>(parameters.beta);
    long fragments = 0, outside = 0, off = 0;
    for (const char* id : {"planes", "spheres", "teapots"}) {
        const Scene scene = load_scene(id, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        View view = view_of(scene, technique.id, {96, 54});
        view.parameters = values;
        renderer.render(view);
        for (const PixelCapture& capture : renderer.capture_region({0, 0}, view.size)) {
            const auto exact = exact_function(capture.ray, technique, parameters);
            if (!exact) continue;
            const Real b0 = total_absorbance(capture.ray);
            for (std::size_t i = 0; i < capture.ray.fragments.size(); ++i) {
                const Real t = capture.transmittance[i];
                const ExactFraction fraction = (*exact)(static_cast<Real>(capture.ray.fragments[i].depth));
                const Real expected = exp(-b0 * (fraction.in_front + beta * fraction.query_weight));
                outside += t >= 0 && t <= 1 ? 0 : 1;  // the condition is false for NaN
                off += abs(t - expected) > FAILED_ERROR ? 1 : 0;
                ++fragments;
            }
        }
    }
    fmt::print("{}: of {} fragments {} have no T in [0, 1], {} are off\n", technique.id, fragments, outside,
               off);
    EXPECT_GT(fragments, 20'000);
    EXPECT_EQ(outside, 0);
    // The preset was chosen so that one random query in a thousand fails; eight power moments reach 1.4 in a
    // thousand here.
    EXPECT_LE(off, fragments / 500);
}

// With the textbook solver and floats, because rounding to 16 bits already keeps matrices from being
// singular.
class TextbookFailures : public Failures {};

TEST_P(TextbookFailures, WithoutBiasAreSeen) {
    ParameterValues values;
    values.set(Solver::textbook);
    values.set(ParameterId::alpha, 0.0f);
    EXPECT_GT(count("planes", values).failed, 100) << GetParam()->id;
    values.set(ParameterId::alpha, 0.01f);
    EXPECT_EQ(count("planes", values).failed, 0) << GetParam()->id << ": that is what bias is for";
}

INSTANTIATE_TEST_SUITE_P(Techniques, TextbookFailures,
                         testing::ValuesIn(moment_techniques_where([](const Technique& row) {
                             return row.moment_kernel().has_textbook && row.moment_kernel().bits == 32;
                         })),
                         [](const auto& row) { return test_name(*row.param); });

INSTANTIATE_TEST_SUITE_P(Techniques, Failures, testing::ValuesIn(kernel_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
