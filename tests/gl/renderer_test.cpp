// renderer_test.cpp -- invalidation, compositing, the tone map, and what is refused;
// second_pass_test.cpp compares the second pass with C++.
#include <fmt/format.h>

#include <functional>

#include "core/compare/difference.hpp"
#include "core/gl/texture.hpp"
#include "core/render/scene_size.hpp"
#include "core/scene/shapes.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class RendererTest : public GlTest<> {};

struct Counts {
    int opaque, moments, color, composite;
    friend bool operator==(const Counts&, const Counts&) = default;
};

Counts difference(const PassCounts& before, const PassCounts& after) {
    return {after.opaque - before.opaque, after.moments - before.moments, after.color - before.color,
            after.composite - before.composite};
}

TEST_F(RendererTest, AChangeRunsNoMoreStagesThanItNeeds) {
    const Scene scene = load_scene("planes", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    View view = view_of(scene, "trig3-32", {64, 48});
    const auto redraw = [&] {
        const PassCounts before = renderer.pass_counts();
        renderer.render(view);
        return difference(before, renderer.pass_counts());
    };
    const Counts everything = {1, 1, 1, 1};
    EXPECT_EQ(redraw(), everything);
    EXPECT_EQ(redraw(), (Counts{0, 0, 0, 0})) << "nothing changed";
    view.parameters.set(ParameterId::beta, 0.5f);
    EXPECT_EQ(redraw(), (Counts{0, 0, 1, 1})) << "beta touches the second pass only";
    view.parameters.set(ParameterId::alpha, 1e-3f);
    EXPECT_EQ(redraw(), (Counts{0, 0, 1, 1})) << "alpha touches the second pass only";
    view.parameters.set(ParameterId::theta, 1.0f);
    EXPECT_EQ(redraw(), (Counts{0, 1, 1, 1})) << "theta touches both passes";
    view.parameters.set(Renormalization::off);
    EXPECT_EQ(redraw(), (Counts{0, 0, 0, 1})) << "renormalisation touches the composite only";
    view.camera.azimuth += 0.1f;
    EXPECT_EQ(redraw(), everything) << "the camera touches everything";
    view.technique = &require_technique("power4-32");
    EXPECT_EQ(redraw(), (Counts{0, 1, 1, 1})) << "opaque surfaces do not depend on the technique";
    view.parameters.set(ParameterId::theta, 2.0f);
    EXPECT_EQ(redraw(), (Counts{0, 0, 0, 0})) << "power moments have no wrapping zone";
}

// A picture after incremental changes must equal a picture that is drawn from scratch.
TEST_F(RendererTest, ChangesLeaveNoTrace) {
    const Scene scene = load_scene("planes", 0.4f);
    View view = view_of(scene, "trig2-32", {64, 48});
    Renderer changed(shared_programs());
    changed.set_scene(scene);
    changed.render(view);
    view.parameters.set(ParameterId::beta, 0.7f);
    changed.render(view);
    view.parameters.set(ParameterId::theta, 0.9f);
    changed.render(view);
    view.technique = &require_technique("sorted");
    changed.render(view);
    view.technique = &require_technique("power6-32");
    changed.render(view);
    Renderer fresh(shared_programs());
    fresh.set_scene(scene);
    fresh.render(view);
    EXPECT_EQ(changed.read_picture().pixels, fresh.read_picture().pixels);
}

// The first passes of Moment Transparency may store values that depend on parameters of the second pass.
TEST_F(RendererTest, ChangesOfWhatIsReadEarlyLeaveNoTrace) {
    const Scene scene = load_scene("spheres", 0.4f);
    for (const auto& [early, value] :
         {std::pair(ParameterId::moment_passes, 1.0f), std::pair(ParameterId::read_format, 3.0f)}) {
        View view = view_of(scene, "mt", {64, 48});
        view.parameters.set(early, value);
        Renderer changed(shared_programs()), fresh(shared_programs());
        changed.set_scene(scene);
        changed.render(view);
        const Image before = changed.read_picture();
        view.parameters.set(ParameterId::beta, 0.7f);
        view.parameters.set(ParameterId::alpha, 1e-3f);
        changed.render(view);
        fresh.set_scene(scene);
        fresh.render(view);
        EXPECT_EQ(changed.read_picture().pixels, fresh.read_picture().pixels);
        EXPECT_NE(changed.read_picture().pixels, before.pixels);
    }
}

// Sheets with known opacities in front of a wall; the reference is composited by hand.
TEST_F(RendererTest, SortedCompositesByHand) {
    const Scene scene = load_scene("planes", 0.4f);
    const glm::ivec2 size(160, 90);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "sorted", size));
    const Image picture = renderer.read_picture();
    Scene bare = scene;
    std::erase_if(bare.objects, [](const Object& object) { return !object.opaque(); });
    Renderer opaque(shared_programs());
    opaque.set_scene(bare);
    opaque.render(view_of(bare, "sorted", size));
    const Image wall = opaque.read_picture();
    for (const glm::ivec2 pixel :
         {glm::ivec2(80, 45), glm::ivec2(60, 50), glm::ivec2(100, 30), glm::ivec2(2, 2)}) {
        const ViewRay ray = renderer.capture_pixel(pixel).ray;
        glm::dvec3 color(0);
        double transmittance = 1;
        for (const std::size_t i : front_to_back(ray)) {
            const Fragment& f = ray.fragments[i];
            color += transmittance * static_cast<double>(f.opacity) * glm::dvec3(f.color);
            transmittance *= 1 - static_cast<double>(f.opacity);
        }
        color += transmittance * glm::dvec3(wall.at(pixel.x, pixel.y));
        for (int c = 0; c < 3; ++c)  // float compositing of at most 4 fragments
            EXPECT_NEAR(static_cast<double>(picture.at(pixel.x, pixel.y)[c]), color[c], 1e-6);
    }
    EXPECT_EQ(renderer.capture_pixel({80, 45}).ray.fragments.size(), 4u) << "the middle sees all four sheets";
}

// The paper's order of quality, on a scene like the paper's.
TEST_F(RendererTest, MoreMomentsAreCloserToTheTruth) {
    const Scene scene = load_scene("teapots", 0.4f);
    const glm::ivec2 size(480, 270);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "sorted", size));
    const Image truth = renderer.read_picture();
    const auto error = [&](const char* technique) {
        renderer.render(view_of(scene, technique, size));
        const double rms = mean_difference(truth, renderer.read_picture(), Metric::rmse);
        fmt::print("teapots {}: rms error {:.5f}\n", technique, rms);
        return rms;
    };
    const double power4 = error("power4-32"), power6 = error("power6-32"), power8 = error("power8-32");
    const double trig2 = error("trig2-32"), trig3 = error("trig3-32"), trig4 = error("trig4-32");
    EXPECT_LT(power6, power4);
    EXPECT_LT(power8, power6);
    EXPECT_LT(trig3, trig2);
    EXPECT_LT(trig4, trig3);
}

// The tone map comes after the picture, so no pass runs again and the picture stays linear.
TEST_F(RendererTest, TheToneMapChangesWhatIsShownAlone) {
    const Scene scene = load_scene("planes", 0.4f);
    const auto shown = [](const Renderer& renderer) {
        return read_texture_bytes(renderer.display_texture(), {64, 36});
    };
    for (const char* technique : {"power4-32", "sorted", "wboit"}) {
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        View view = view_of(scene, technique, {64, 36});
        renderer.render(view);
        const Image linear = renderer.read_picture();
        for (const float choice : {0.0f, 1.0f, 2.0f}) {
            const PassCounts before = renderer.pass_counts();
            view.parameters.set(ParameterId::tone_map, choice);
            renderer.render(view);
            EXPECT_EQ(difference(before, renderer.pass_counts()), (Counts{0, 0, 0, 0}));
            EXPECT_EQ(renderer.read_picture().pixels, linear.pixels);
            const std::vector<unsigned char> bytes = shown(renderer);
            for (int x = 0; x < 64; ++x) {
                const glm::vec4 color = linear.at(x, 35);  // GL counts rows from below
                for (int c = 0; c < 3; ++c) {
                    const float mapped = tone_mapped(color[c], tone_map_of(view.parameters));
                    EXPECT_NEAR(bytes[static_cast<std::size_t>(4 * x + c)], 255 * srgb_from_linear(mapped),
                                1.0f);
                }
            }
        }
    }
}

TEST_F(RendererTest, RefusesSizesThatCannotBeDrawn) {
    const Scene scene = load_scene("planes", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    EXPECT_THROW(renderer.render(view_of(scene, "sorted", {0, 5})), Error);
    EXPECT_THROW(renderer.render(view_of(scene, "sorted", {5, MAX_PICTURE_SIDE + 1})), Error);
    renderer.render(view_of(scene, "sorted", {1, 1}));
    EXPECT_EQ(renderer.read_picture().pixels.size(), 1u);
}

/// The message of the Error that `run` must throw.
std::string refusal(const std::function<void()>& run) {
    try {
        run();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST_F(RendererTest, TexturesThatTheMemoryDoesNotHoldAreNamed) {
    const std::string said = refusal([] { make_layered_texture(GL_RGBA32F, {16384, 16384}, 2048); });
    EXPECT_NE(said.find("memory ran out while making 2048 textures of 16384x16384"), std::string::npos)
        << said;
}

TEST_F(RendererTest, RefusesScenesThatAreTooLargeBeforeTheyTakeMemory) {
    for (const SceneEntry& entry : scene_entries()) EXPECT_NO_THROW(require_drawable(size_of(entry.build())));
    const Scene planes = load_scene("planes", 0.4f);
    EXPECT_EQ(size_of(planes).vertices, 8u);
    EXPECT_EQ(size_of(planes).bytes(), 8u * 32 + 12 * 4 + 5 * 256);
    // 20 million triangles, the maximum for a file, without shared vertices.
    EXPECT_NO_THROW(require_drawable({60'000'000, 60'000'000, 2, 0, 60'000'000}));
    const std::string bytes = refusal([] {
        require_drawable({200'000'000, 300'000'000, 1, 0, 300'000'000});
    });
    EXPECT_EQ(
        bytes,
        "The scene needs 7.1 GiB of graphics memory for 200000000 vertices, 100000000 triangles, 1 objects and 0 "
        "texels, more than the limit of 4 GiB; simplify it.");
    const std::string count = refusal([] { require_drawable({3, 2'147'483'649, 1, 0, 2'147'483'649}); });
    EXPECT_NE(count.find("715827883 triangles, more than the 715827882"), std::string::npos) << count;

    // The renderer checks the size before anything is read, so the last scene stays.
    Renderer renderer(shared_programs());
    renderer.set_scene(planes);
    renderer.render(view_of(planes, "sorted", {32, 18}));
    const Image before = renderer.read_picture();
    Scene large = planes;
    large.alpha_maps.push_back({65'536, 65'537, {}});
    EXPECT_NE(refusal([&] { renderer.set_scene(large); }).find("4295032832 texels"), std::string::npos);
    View again = view_of(planes, "sorted", {32, 18});
    again.camera.azimuth += 1;
    renderer.render(again);
    renderer.render(view_of(planes, "sorted", {32, 18}));
    EXPECT_EQ(renderer.read_picture().pixels, before.pixels);
}

// One row of 2.6 million fragments, which cannot be split into bands.
TEST_F(RendererTest, RefusesRowsThatSortedCannotHold) {
    Scene scene;
    scene.camera = {glm::vec3(0), 1.0f, 0.0f, 0.0f, 0.8f};
    scene.meshes = {make_rectangle(20'000.0f, 20.0f, 1, 1)};
    scene.objects.resize(320, {0, glm::mat4(1), glm::vec3(1), 0.01f});
    Renderer renderer(shared_programs());
    if (!renderer.gl().storage) GTEST_SKIP() << "sorted peels here, and needs no rows";
    renderer.set_scene(scene);
    EXPECT_EQ(
        refusal([&] {
            renderer.render(view_of(scene, "sorted", {8192, 1}));
        }),
        "One row of the picture has 2621440 transparent fragments (125 MB), more than the 2500000 (120 MB) that "
        "sorted can hold; use a smaller --size.");
    renderer.render(view_of(scene, "sorted", {64, 1}));  // fewer fragments fit
}

}  // namespace
}  // namespace momentscope::test
