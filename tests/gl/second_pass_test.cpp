// second_pass_test.cpp -- agreement of GL and C++ on real pixels.
#include <fmt/format.h>

#include <bit>
#include <tuple>
#include <vector>

#include "core/inspect/fragment_estimates.hpp"
#include "tests/effort.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

class SecondPass : public GlTest<testing::TestWithParam<std::tuple<const Technique*, const char*>>> {};

// Compares T of every fragment of a picked pixel: the value of the second pass on the GL, and the value that
// C++ computes from the captured fragments.
TEST_P(SecondPass, ComputesTheBitsOfCpp) {
    const auto [technique, scene_id] = GetParam();
    if (const std::string why = why_unavailable(*technique, shared_programs()->gl()); !why.empty())
        GTEST_SKIP() << why;
    const Scene scene = load_scene(scene_id, 0.4f);
    const glm::ivec2 size(320, 180);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, technique->id, size));
    long fragments = 0;
    long different = 0;
    for (int i = 0; i < effort(25, 60); ++i) {
        const glm::ivec2 pixel =
            i == 0 ? picked_pixel(scene, size) : glm::ivec2((i * 53) % size.x, (i * 37) % size.y);
        const PixelCapture capture = renderer.capture_pixel(pixel);
        std::vector<float> depths;
        for (const Fragment& f : capture.ray.fragments) depths.push_back(f.depth);
        const auto estimates = fragment_estimates(capture.ray, *technique, resolve({}, *technique));
        ASSERT_EQ(capture.transmittance.size(), depths.size());
        for (std::size_t k = 0; k < depths.size(); ++k) {
            EXPECT_EQ(capture.ray.fragments[k].depth,
                      to_depth(capture.ray.fragments[k].view_depth, capture.ray.warp));
            const float cpp = estimates[k].transmittance;
            different += std::bit_cast<int>(cpp) != std::bit_cast<int>(capture.transmittance[k]) ? 1 : 0;
            ++fragments;
        }
    }
    fmt::print("{} {}: T of {} of {} fragments differs\n", scene_id, technique->id, different, fragments);
    EXPECT_GT(fragments, 10);
    EXPECT_EQ(different, 0);
}

INSTANTIATE_TEST_SUITE_P(Techniques, SecondPass,
                         testing::Combine(testing::ValuesIn(moment_based_techniques()),
                                          testing::Values("planes", "spheres", "teapots")),
                         [](const auto& row) {
                             return test_name(*std::get<0>(row.param)) + "_" + std::get<1>(row.param);
                         });

}  // namespace
}  // namespace momentscope::test
