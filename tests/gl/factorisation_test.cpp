// factorisation_test.cpp -- with one factor per pixel, every fragment gets the result that it would compute
// itself, and the factor follows every change of moments or bias. Also tests the map of needed moments on a
// scene with a known answer.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

#include "core/inspect/moments_needed.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 FACTORISATION_SIZE{96, 54};

ParameterValues values_for(bool once, float alpha_scale, const Technique& technique) {
    ParameterValues values;
    values.set(once ? Factorisation::per_pixel : Factorisation::per_fragment);
    values.set(ParameterId::alpha, alpha_scale * automatic_bias(values, technique));
    return values;
}

std::vector<float> transmittances(Renderer& renderer) {
    std::vector<float> all;
    for (const PixelCapture& capture : renderer.capture_region({0, 0}, FACTORISATION_SIZE))
        all.insert(all.end(), capture.transmittance.begin(), capture.transmittance.end());
    return all;
}

class FactorisationTest : public GlTest<testing::TestWithParam<const Technique*>> {};

TEST_P(FactorisationTest, OncePerPixelGivesTheSameTransmittance) {
    const Technique& technique = *GetParam();
    for (const char* id : {"teapots", "ship"}) {
        const Scene scene = load_scene(id, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        // Change the bias, then the camera, so that the stored factors are stale twice.
        for (const auto& [alpha_scale, turn] :
             {std::pair(1.0f, 0.0f), std::pair(3.0f, 0.0f), std::pair(3.0f, 0.2f)}) {
            Camera camera = scene.camera;
            camera.azimuth += turn;
            std::vector<float> found[2];
            for (const bool once : {true, false}) {
                renderer.render(
                    {camera, FACTORISATION_SIZE, &technique, values_for(once, alpha_scale, technique)});
                found[once] = transmittances(renderer);
            }
            ASSERT_EQ(found[0].size(), found[1].size());
            ASSERT_GT(found[0].size(), 2000u) << "a scene with few fragments tests little";
            std::size_t different = 0, far = 0;
            for (std::size_t i = 0; i < found[0].size(); ++i) {
                different += std::bit_cast<int>(found[0][i]) == std::bit_cast<int>(found[1][i]) ? 0 : 1;
                far += std::abs(found[0][i] - found[1][i]) <= 1e-5f ? 0 : 1;
            }
            fmt::print("{} on {}: {} of {} fragments differ, {} by more than 1e-5\n", technique.id, id,
                       different, found[0].size(), far);
            EXPECT_LE(far, found[0].size() / 1000);
        }
    }
}

std::vector<const Technique*> rows() {
    std::vector<const Technique*> rows = moment_based_techniques();
    // Of those that know the ends, the one with the smallest and the one with the largest factor are enough.
    std::erase_if(rows, [](const Technique* row) {
        const std::string_view id = row->id;
        const bool of_others = row->moments().estimation && id != "certain4" && id != "sharp8";
        return of_others || !row->uses(ParameterId::factorisation);
    });
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Techniques, FactorisationTest, testing::ValuesIn(rows()), [](const auto& row) {
    std::string name = row.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
});

class NeededMapTest : public GlTest<testing::Test> {};

TEST_F(NeededMapTest, OfPlanesIsWhatTheNumberOfSheetsSays) {
    const Scene scene = load_scene("planes", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "sorted", FACTORISATION_SIZE));
    constexpr std::array WANTED = {Needed::nothing, Needed::four, Needed::four, Needed::four, Needed::six};
    std::map<std::size_t, long> pixels;
    for (const char* basis : {"power", "chebyshev"})
        for (const PixelCapture& capture : renderer.capture_region({0, 0}, FACTORISATION_SIZE)) {
            const std::size_t sheets = capture.ray.fragments.size();
            ++pixels[sheets];
            EXPECT_EQ(pixel_need(capture.ray, moment_orders(basis), {}).by_certificate, WANTED.at(sheets))
                << sheets;
        }
    EXPECT_EQ(pixels.size(), 5u) << "none to four sheets";
}

}  // namespace
}  // namespace momentscope::test
