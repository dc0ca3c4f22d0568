// peeling_test.cpp -- compares two ground truths that share nothing but the scene; and the map of failures.
#include <fmt/format.h>

#include <algorithm>

#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class PeelingTest : public GlTest<> {};

/// Renders with one technique, as 8-bit sRGB.
Image picture(const Scene& scene, const char* technique, glm::ivec2 size) {
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, technique, size));
    return renderer.read_picture();
}

/// The pixels with sRGB channels that differ by more than 1/255.
std::vector<glm::ivec2> differing_pixels(const Image& a, const Image& b) {
    std::vector<glm::ivec2> pixels;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        bool same = true;
        for (int c = 0; c < 3; ++c)
            same &= 255 * std::abs(srgb_from_linear(a.pixels[i][c]) - srgb_from_linear(b.pixels[i][c])) <= 1;
        if (!same) pixels.emplace_back(static_cast<int>(i) % a.width, static_cast<int>(i) / a.width);
    }
    return pixels;
}

/// The share of these pixels.
double differing(const Image& a, const Image& b) {
    return static_cast<double>(differing_pixels(a, b).size()) / static_cast<double>(a.pixels.size());
}

/// Are two fragments so close that the depth buffer cannot distinguish them, so that peeling loses one?
bool has_tie(const PixelCapture& capture) {
    std::vector<float> depths;
    for (const Fragment& fragment : capture.ray.fragments) depths.push_back(fragment.view_depth);
    std::ranges::sort(depths);
    for (std::size_t i = 1; i < depths.size(); ++i) {
        // Window depth is nearly 1 - near / z, in floats 2^-24 apart, and is rounded a few times on its way.
        const float apart = 4.0f * 0x1p-24f * depths[i] * depths[i] / NEAR_PLANE;
        if (depths[i] - depths[i - 1] < apart) return true;
    }
    return false;
}

TEST_F(PeelingTest, AgreesWithSortedOnEveryScene) {
    for (const char* id : {"planes", "spheres", "teapots"}) {
        const Scene scene = load_scene(id, 0.4f);
        const glm::ivec2 size(480, 270);
        const double share = differing(picture(scene, "sorted", size), picture(scene, "peeling", size));
        RecordProperty(id, fmt::format("{}", share));
        EXPECT_LE(share, 1e-4) << id << ": 99.99 % of the pixels must agree within 1/255";
    }
}

// Leaves and blades of grass cross each other, so depths tie along lines.
TEST_F(PeelingTest, AgreesWithSortedWhereNoDepthsTie) {
    for (const char* id : {"foliage", "ship", "smoke"}) {
        const Scene scene = load_scene(id, 0.4f);
        const glm::ivec2 size(240, 135);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        renderer.render(view_of(scene, "sorted", size));
        const auto pixels = differing_pixels(renderer.read_picture(), picture(scene, "peeling", size));
        long without_tie = 0;
        for (const glm::ivec2& pixel : pixels) without_tie += has_tie(renderer.capture_pixel(pixel)) ? 0 : 1;
        RecordProperty(id, fmt::format("{} of {}", without_tie, pixels.size()));
        EXPECT_LE(without_tie, 1e-4 * size.x * size.y) << id;
        EXPECT_LE(static_cast<double>(pixels.size()), 2e-3 * size.x * size.y) << id << ": ties are rare";
    }
}

// Check that the comparison can fail: with one sheet fewer, pictures differ.
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
    Renderer renderer(shared_programs());
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
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "power4-32", {64, 48}));
    const Image whole = renderer.read_picture();
    const Image region = renderer.read_region({20, 30}, {5, 3});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) EXPECT_EQ(region.at(x, y), whole.at(20 + x, 30 + y));
    EXPECT_GT(renderer.pass_times().color, 0) << "the GL measures its passes";
}

// Equation 2 computed by hand, from the fragments and the T of the second pass. Sums are in half floats, so 3
// digits agree.
TEST_F(PeelingTest, MomentsCompositeByHand) {
    const Scene scene = load_scene("planes", 0.4f);
    for (const float renormalize : {0.0f, 1.0f}) {
        Renderer renderer(shared_programs());
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
