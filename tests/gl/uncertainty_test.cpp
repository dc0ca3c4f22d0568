// uncertainty_test.cpp -- what the bounds leave open, summed by the GPU, is what C++ sums over the captured
// fragments.
#include "core/inspect/color_uncertainty.hpp"
#include "core/techniques/configuration.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 UNCERTAINTY_SIZE(48, 27);

class Uncertainty : public GlTest<testing::TestWithParam<const char*>> {};

// Both add floats of the same bounds, in another order: 60 fragments make 60 roundings of 6e-8, and colours
// are shaded by two compilers.
TEST_P(Uncertainty, OfThePictureIsThatOfItsFragments) {
    constexpr float TOLERANCE = 2e-5f;
    for (const char* name : {"spheres", "teapots", "cloud"}) {
        const Scene scene = load_scene(name, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        const Configuration configuration = parse_configuration(GetParam());
        if (const std::string why = why_unavailable(*configuration.technique, renderer.gl()); !why.empty())
            GTEST_SKIP() << why;
        View view = view_of(scene, configuration.technique->id, UNCERTAINTY_SIZE);
        view.parameters = configuration.values;
        renderer.render(view);
        const std::vector<float> drawn = renderer.uncertainty();
        const auto captures = renderer.capture_region({0, 0}, UNCERTAINTY_SIZE);
        ASSERT_EQ(drawn.size(), captures.size());
        double sum = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const ColorUncertainty expected = color_uncertainty(captures[i], configuration);
            EXPECT_NEAR(drawn[i], expected.open, TOLERANCE * (1 + expected.open)) << name << ", pixel " << i;
            sum += static_cast<double>(drawn[i]);
        }
        EXPECT_GT(sum / static_cast<double>(drawn.size()), 1e-4) << name << ": something is open";
    }
}

INSTANTIATE_TEST_SUITE_P(All, Uncertainty,
                         testing::Values("power4-32", "sharp6", "certain8", "trig3-32", "sharp4-16",
                                         "power6-32:estimate=expected,ends=known"),
                         [](const auto& row) { return "row" + std::to_string(row.index); });

class UncertaintyTest : public GlTest<testing::Test> {};

TEST_F(UncertaintyTest, IsThatOfTheRobustSolverAndNeedsMoments) {
    const Scene scene = load_scene("spheres", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    View view = view_of(scene, "power4-32", UNCERTAINTY_SIZE);
    renderer.render(view);
    const std::vector<float> robust = renderer.uncertainty();
    view.parameters.set(Solver::textbook);
    renderer.render(view);
    EXPECT_EQ(renderer.uncertainty(), robust) << "the textbook solver knows no bounds";
    view.technique = &require_technique("sorted");
    renderer.render(view);
    EXPECT_TRUE(renderer.uncertainty().empty());
}

}  // namespace
}  // namespace momentscope::test
