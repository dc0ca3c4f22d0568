// peeling_test.cpp -- two ground truths that share nothing but the scene, compared; and the map of failures.
#include <fmt/format.h>

#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class PeelingTest : public GlTest<> {};

/// Rendered by one technique, as 8-bit sRGB.
Image picture(const Scene& scene, const char* technique, glm::ivec2 size) {
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render(view_of(scene, technique, size));
    return renderer.read_picture();
}

/// The share of pixels whose sRGB channels differ by more than 1/255.
double differing(const Image& a, const Image& b) {
    long count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        bool same = true;
        for (int c = 0; c < 3; ++c)
            same &= 255 * std::abs(srgb_from_linear(a.pixels[i][c]) - srgb_from_linear(b.pixels[i][c])) <= 1;
        count += same ? 0 : 1;
    }
    return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

TEST_F(PeelingTest, AgreesWithSortedOnEveryScene) {
    for (const char* id : {"planes", "spheres", "teapots", "foliage", "smoke"}) {
        const Scene scene = load_scene(id, 0.4f);
        const glm::ivec2 size(480, 270);
        const double share = differing(picture(scene, "sorted", size), picture(scene, "peeling", size));
        RecordProperty(id, fmt::format("{}", share));
        EXPECT_LE(share, 1e-4) << id << ": 99.99 % of the pixels must agree within 1/255";
    }
}

// The comparison can fail: one sheet fewer is seen.
TEST_F(PeelingTest, TheComparisonSeesAMissingSheet) {
    Scene scene = load_scene("planes", 0.4f);
    const Image whole = picture(scene, "sorted", {240, 135});
    std::erase_if(scene.objects, [found = false](const Object& object) mutable {
        return !object.opaque() && !std::exchange(found, true);
    });
    EXPECT_GT(differing(whole, picture(scene, "peeling", {240, 135})), 0.05);
}

TEST_F(PeelingTest, WithoutTransparencyItIsTheOpaquePicture) {
    Scene scene = load_scene("planes", 0.4f);
    std::erase_if(scene.objects, [](const Object& object) { return !object.opaque(); });
    EXPECT_EQ(differing(picture(scene, "peeling", {64, 36}), picture(scene, "sorted", {64, 36})), 0);
}

TEST_F(PeelingTest, FailuresAppearWithoutBiasAndOnlyThen) {
    const Scene scene = load_scene("spheres", 0.4f);
    Renderer renderer;
    renderer.set_scene(scene);
    View view = view_of(scene, "power8-32", {160, 90});
    renderer.render(view);
    const auto biased = renderer.draw_failures();
    ASSERT_TRUE(biased);
    EXPECT_EQ(biased->failed, 0);
    view.parameters.set(ParameterId::alpha, 0.0f);
    renderer.render(view);
    const auto unbiased = renderer.draw_failures();
    ASSERT_TRUE(unbiased);
    EXPECT_GT(unbiased->failed, 500) << "most of the spheres' pixels";
    view.technique = &require_technique("sorted");
    renderer.render(view);
    EXPECT_FALSE(renderer.draw_failures()) << "sorting reconstructs nothing";
}

TEST_F(PeelingTest, ARegionIsCutOutOfThePicture) {
    const Scene scene = load_scene("spheres", 0.4f);
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "power4-32", {64, 48}));
    const Image whole = renderer.read_picture();
    const Image region = renderer.read_region({20, 30}, {5, 3});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) EXPECT_EQ(region.at(x, y), whole.at(20 + x, 30 + y));
    EXPECT_GT(renderer.pass_times().color, 0) << "the GL measures its passes";
}

// Equation 2 by hand, from the fragments and T that the second pass gave them: sums in half floats, so 3
// digits.
TEST_F(PeelingTest, MomentsCompositeByHand) {
    const Scene scene = load_scene("planes", 0.4f);
    for (const float renormalize : {0.0f, 1.0f}) {
        Renderer renderer;
        renderer.set_scene(scene);
        View view = view_of(scene, "power4-32", {64, 36});
        view.parameters.set(ParameterId::renormalize, renormalize);
        renderer.render(view);
        const Image drawn = renderer.read_picture();
        Scene bare = scene;
        std::erase_if(bare.objects, [](const Object& object) { return !object.opaque(); });
        const Image opaque = picture(bare, "sorted", {64, 36});
        for (const glm::ivec2 pixel : {glm::ivec2(32, 18), glm::ivec2(26, 18), glm::ivec2(20, 20)}) {
            const PixelCapture capture = renderer.capture_pixel(pixel);
            glm::vec3 sum(0);
            float weights = 0;
            for (std::size_t i = 0; i < capture.ray.fragments.size(); ++i) {
                const Fragment& f = capture.ray.fragments[i];
                const float weight = capture.transmittance[i] * f.opacity;
                sum += weight * f.color;
                weights += weight;
            }
            const auto through = static_cast<float>(std::exp(-total_absorbance(capture.ray)));
            const float scale = renormalize > 0 && weights > 0 ? (1 - through) / weights : 1;
            const glm::vec3 expected = through * glm::vec3(opaque.at(pixel.x, pixel.y)) + scale * sum;
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn.at(pixel.x, pixel.y)[c], expected[c], 2e-3f);
        }
    }
}

}  // namespace
}  // namespace momentscope::test
