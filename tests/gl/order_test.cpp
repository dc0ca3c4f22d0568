// order_test.cpp -- the order of submission changes the pictures of exactly those techniques that declare it.
#include <algorithm>

#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

std::vector<const Technique*> drawn_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques()) rows.push_back(&row);
    return rows;
}

class OrderTest : public GlTest<::testing::TestWithParam<const Technique*>> {};

TEST_P(OrderTest, MattersWhereItIsSaid) {
    const Technique& technique = *GetParam();
    const Scene scene = load_scene("cloud", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    if (const std::string why = why_unavailable(technique, renderer.gl()); !why.empty()) GTEST_SKIP() << why;
    View view = view_of(scene, technique.id, {96, 54});
    renderer.render(view);
    const Image submitted = renderer.read_picture();
    for (const float order : {1.0f, 2.0f}) {  // reversed, shuffled
        view.parameters.set(ParameterId::order, order);
        renderer.render(view);
        const Image other = renderer.read_picture();
        float most = 0;
        for (std::size_t i = 0; i < other.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(other.pixels[i][c] - submitted.pixels[i][c]));
        // Half floats of colours are rounded in another order; 16-bit moments are also rounded after every
        // fragment.
        if (!technique.order_dependent)
            EXPECT_LT(most, 8e-3f);
        else if (!technique.has_moments())
            EXPECT_GT(most, 0.02f);
        else
            EXPECT_GT(most, 0.0f);
    }
    view.parameters.set(OrderKind::submitted);
    renderer.render(view);
    EXPECT_EQ(renderer.read_picture().pixels, submitted.pixels) << "back to the first one";
}

INSTANTIATE_TEST_SUITE_P(Techniques, OrderTest, ::testing::ValuesIn(drawn_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

TEST(SubmissionOrderTest, CapturedFragmentsComeInIt) {
    shared_context();
    const Scene scene = load_scene("teapots", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    View view = view_of(scene, "sorted", {96, 54});
    renderer.render(view);
    const glm::ivec2 pixel = picked_pixel(scene, view.size);
    std::vector<float> depths, backwards;
    for (const Fragment& f : renderer.capture_pixel(pixel).ray.fragments) depths.push_back(f.view_depth);
    view.parameters.set(OrderKind::reversed);
    renderer.render(view);
    for (const Fragment& f : renderer.capture_pixel(pixel).ray.fragments) backwards.push_back(f.view_depth);
    ASSERT_GT(depths.size(), 3U);
    std::ranges::reverse(backwards);
    EXPECT_EQ(depths, backwards);
}

}  // namespace
}  // namespace momentscope::test
