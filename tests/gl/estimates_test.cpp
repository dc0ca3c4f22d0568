// estimates_test.cpp -- a renderer that goes from one way to estimate T to another draws what a new one
// draws.
#include <vector>

#include "core/techniques/configuration.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 ESTIMATES_SIZE(96, 54);

ParameterValues estimated(Estimate estimate, RayEnds ends, MomentInterval interval,
                          Renormalization renormalization) {
    ParameterValues values;
    values.set(estimate);
    values.set(ends);
    values.set(interval);
    values.set(renormalization);
    return values;
}

// Each step changes what a pixel stores or how it is read: more and fewer numbers of a factor, the ends with
// and before the moments, a second target.
std::vector<ParameterValues> steps_of(const Technique& technique) {
    using enum Estimate;
    using enum MomentInterval;
    using enum Renormalization;
    std::vector<ParameterValues> steps = {{},
                                          estimated(beta, RayEnds::known, scene, uniform),
                                          estimated(expected, RayEnds::known, pixel, uncertain),
                                          estimated(expected, RayEnds::known, scene, uncertain),
                                          estimated(own_beta, RayEnds::off, scene, off),
                                          {}};
    std::erase_if(steps,
                  [&](const ParameterValues& values) { return why_refused(technique, values) != nullptr; });
    return steps;
}

class Estimates : public GlTest<testing::TestWithParam<const Technique*>> {};

TEST_P(Estimates, AreThoseOfANewRenderer) {
    if (const std::string why = why_unavailable(*GetParam(), shared_programs()->gl()); !why.empty())
        GTEST_SKIP() << why;
    const Scene scene = load_scene("spheres", 0.4f);
    Renderer kept(shared_programs());
    kept.set_scene(scene);
    View view = view_of(scene, GetParam()->id, ESTIMATES_SIZE);
    for (const ParameterValues& values : steps_of(*GetParam())) {
        view.parameters = values;
        kept.render(view);
        Renderer fresh(shared_programs());
        fresh.set_scene(scene);
        fresh.render(view);
        EXPECT_EQ(kept.read_picture().pixels, fresh.read_picture().pixels)
            << configuration_text({GetParam(), values});
        const glm::ivec2 middle = ESTIMATES_SIZE / 2;
        const auto now = kept.capture_pixel(middle).stored, then = fresh.capture_pixel(middle).stored;
        ASSERT_TRUE(now && then);
        EXPECT_EQ(now->near_step, then->near_step) << configuration_text({GetParam(), values});
    }
}

// The factors of trig3-32 have as many texels with and without ends, but of other formats.
INSTANTIATE_TEST_SUITE_P(Techniques, Estimates,
                         testing::Values(&require_technique("cheb4-32"), &require_technique("cheb6-32"),
                                         &require_technique("trig3-32"), &require_technique("power4-16")),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
