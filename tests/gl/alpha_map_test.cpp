// alpha_map_test.cpp -- opacity textures: compares the samples of the passes with bilinear interpolation in
// C++, and tests fragments of opacity 0.
#include <algorithm>

#include "core/scene/shapes.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 ALPHA_MAP_SIZE(96, 54);
constexpr float OPACITY = 0.8f;

class AlphaMapTest : public GlTest<> {};

/// 4 x 4 texels; the lower left quarter is 0.
AlphaMap small_map() {
    return {4, 4, {0, 0, 255, 128, 0, 0, 192, 255, 0, 64, 192, 255, 90, 160, 255, 30}};
}

/// A wall, a sheet without a map, and in front a sheet with a map: 3 x 2 units in the middle of the picture.
Scene mapped_sheet() {
    Scene scene;
    scene.camera = {glm::vec3(0), 4.0f, 0.0f, 0.0f, 0.8f};
    Mesh sheet = make_rectangle(3.0f, 2.0f, 1, 1);
    for (const glm::vec3& position : sheet.positions)
        sheet.texture_coordinates.emplace_back(position.x / 3.0f + 0.5f, position.y / 2.0f + 0.5f);
    scene.meshes = {make_rectangle(20.0f, 20.0f, 1, 1), sheet};
    scene.alpha_maps = {{1, 1, {40}}, small_map()};
    glm::mat4 behind(1), far_behind(1);
    behind[3].z = -1;
    far_behind[3].z = -2;
    scene.objects = {{0, far_behind, glm::vec3(0.8f), 1.0f},
                     {1, glm::mat4(1), glm::vec3(0.9f, 0.4f, 0.1f), OPACITY, 1},
                     {0, behind, glm::vec3(0.2f, 0.4f, 0.9f), 0.5f}};
    return scene;
}

/// Linear filter with repetition; `place` is in [0, 1].
float sampled(const AlphaMap& map, glm::vec2 place) {
    const glm::vec2 at = place * glm::vec2(map.width, map.height) - 0.5f;
    const glm::ivec2 cell(glm::floor(at));
    const glm::vec2 within = at - glm::vec2(cell);
    const auto texel = [&](int dx, int dy) {
        const int x = (cell.x + dx + map.width) % map.width, y = (cell.y + dy + map.height) % map.height;
        return static_cast<float>(map.bytes[static_cast<std::size_t>(y * map.width + x)]) / 255.0f;
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), within.x),
                    glm::mix(texel(0, 1), texel(1, 1), within.x), within.y);
}

/// The texture coordinate at which the ray through the middle of a pixel hits the sheet.
glm::vec2 place_of(const Camera& camera, glm::ivec2 pixel) {
    const glm::vec2 ndc = (glm::vec2(pixel) + 0.5f) / glm::vec2(ALPHA_MAP_SIZE) * 2.0f - 1.0f;
    const float half_height = camera.distance * std::tan(0.5f * camera.field_of_view);
    const glm::vec2 at(ndc.x * half_height * float(ALPHA_MAP_SIZE.x) / float(ALPHA_MAP_SIZE.y),
                       -ndc.y * half_height);
    return at / glm::vec2(3.0f, 2.0f) + 0.5f;
}

TEST_F(AlphaMapTest, FragmentsHaveTheOpacityOfTheirPlaceOnTheMap) {
    const Scene scene = mapped_sheet();
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "sorted", ALPHA_MAP_SIZE));
    const auto captures = renderer.capture_region({0, 0}, ALPHA_MAP_SIZE);
    int on_sheet = 0;
    for (int y = 0; y < ALPHA_MAP_SIZE.y; ++y) {
        for (int x = 0; x < ALPHA_MAP_SIZE.x; ++x) {
            const auto& fragments =
                captures[static_cast<std::size_t>(y * ALPHA_MAP_SIZE.x + x)].ray.fragments;
            if (fragments.size() != 2) continue;
            ++on_sheet;
            const float expected = OPACITY * sampled(small_map(), place_of(scene.camera, {x, y}));
            // Texture units interpolate with about 8 bits.
            EXPECT_NEAR(fragments[0].opacity, expected, 0.012f) << x << "," << y;
            EXPECT_EQ(fragments[1].opacity, 0.5f) << "an object without a map";
        }
    }
    EXPECT_GT(on_sheet, 1500);
}

// If the map is 0 over the whole footprint of a pixel, the pixel looks as if the sheet was not there, with
// every technique.
TEST_F(AlphaMapTest, OpacityZeroChangesNoTechnique) {
    const Scene scene = mapped_sheet();
    Scene without = scene;
    without.objects.erase(without.objects.begin() + 1);
    const glm::ivec2 inside(ALPHA_MAP_SIZE.x / 2 - 12,
                            ALPHA_MAP_SIZE.y / 2 + 10);  // u about 0.26, v about 0.17
    ASSERT_EQ(sampled(small_map(), place_of(scene.camera, inside)), 0.0f);
    const glm::ivec2 solid(ALPHA_MAP_SIZE.x / 2 + 8, ALPHA_MAP_SIZE.y / 2 - 5);
    ASSERT_GT(sampled(small_map(), place_of(scene.camera, solid)), 0.7f);
    for (const Technique& technique : techniques()) {
        SCOPED_TRACE(technique.id);
        Renderer with_sheet(shared_programs()), bare(shared_programs());
        if (!why_unavailable(technique, bare.gl()).empty()) continue;
        with_sheet.set_scene(scene);
        bare.set_scene(without);
        with_sheet.render(view_of(scene, technique.id, ALPHA_MAP_SIZE));
        bare.render(view_of(without, technique.id, ALPHA_MAP_SIZE));
        const PixelCapture capture = with_sheet.capture_pixel(inside);
        ASSERT_EQ(capture.ray.fragments.size(), 2u);
        EXPECT_EQ(capture.ray.fragments[0].opacity, 0.0f);
        const Image a = with_sheet.read_picture(), b = bare.read_picture();
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(a.at(inside.x, inside.y)[c], b.at(inside.x, inside.y)[c], 2e-3f);
        // Check that the comparison can fail: the next place shows the sheet.
        EXPECT_GT(glm::distance(a.at(solid.x, solid.y), b.at(solid.x, solid.y)), 0.1f);
    }
}

}  // namespace
}  // namespace momentscope::test
