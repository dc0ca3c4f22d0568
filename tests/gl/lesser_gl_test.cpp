// lesser_gl_test.cpp -- a GL that lacks a capability draws the same by other means, and what it cannot draw,
// it says.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "core/bench/gpu_check_report.hpp"
#include "core/chart/grid.hpp"
#include "core/compare/difference.hpp"
#include "core/gl/rounding_check.hpp"
#include "core/scene/shapes.hpp"
#include "tests/effort.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

using LesserGl = GlTest<>;

// Tests on other kinds of GL (kind.sh) must not run on the usual one by mistake.
TEST(KindOfGl, IsTheOneThatWasAskedFor) {
    shared_context();
    const auto variable = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::string(value != nullptr ? value : "");
    };
    std::optional<Dialect> expected;
    if (variable("MESA_GL_VERSION_OVERRIDE").starts_with("4.1")) expected = Dialect::glsl_410;
    if (variable("MESA_GL_VERSION_OVERRIDE").starts_with("3.3")) expected = Dialect::glsl_330;
    if (variable("MOMENTSCOPE_GL") == "egl-es") expected = Dialect::essl_300;
    EXPECT_EQ(current_dialect(), expected.value_or(current_dialect()));
}

/// The share of pixels that differ by more than 1/50 in a channel: those where two fragments share a window
/// depth.
double differing_share(const Image& a, const Image& b) {
    long count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3 off = glm::abs(glm::vec3(a.pixels[i] - b.pixels[i]));
        count += std::max({off.r, off.g, off.b}) > 0.02f ? 1 : 0;
    }
    return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

void expect_same_fragments(const PixelCapture& lists, const PixelCapture& layers, const std::string& where) {
    ASSERT_EQ(lists.ray.fragments.size(), layers.ray.fragments.size()) << where;
    EXPECT_EQ(lists.transmittance, layers.transmittance) << where;
    for (std::size_t i = 0; i < lists.ray.fragments.size(); ++i) {
        const Fragment &a = lists.ray.fragments[i], &b = layers.ray.fragments[i];
        EXPECT_EQ(std::pair(a.draw, a.primitive), std::pair(b.draw, b.primitive)) << where;
        EXPECT_EQ(std::bit_cast<int>(a.depth), std::bit_cast<int>(b.depth)) << where;
        EXPECT_EQ(std::bit_cast<int>(a.view_depth), std::bit_cast<int>(b.view_depth)) << where;
        EXPECT_EQ(std::tuple(a.opacity, a.color, a.seed, a.threshold),
                  std::tuple(b.opacity, b.color, b.seed, b.threshold))
            << where;
    }
}

// 200 pixels of each scene, in strips across the picture.
TEST_F(LesserGl, LayersCaptureTheFragmentsOfLists) {
    if (!shared_programs()->gl().storage) GTEST_SKIP() << "this GL has no lists";
    const auto programs = without_storage();
    const glm::ivec2 size(320, 180), strip(20, 1);
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer lists(shared_programs()), layers(programs);
        std::size_t fragments = 0;
        for (Renderer* renderer : {&lists, &layers}) {
            renderer->set_scene(scene);
            renderer->render(view_of(scene, "power4-32", size));
        }
        for (int i = 0; i < 10; ++i) {
            const glm::ivec2 corner((i * 97) % (size.x - strip.x), 9 + i * 17);
            const auto of_lists = lists.capture_region(corner, strip);
            const auto of_layers = layers.capture_region(corner, strip);
            for (std::size_t k = 0; k < of_lists.size(); ++k) {
                expect_same_fragments(of_lists[k], of_layers[k], fmt::format("{} {} {}", entry.id, i, k));
                fragments += of_lists[k].ray.fragments.size();
            }
        }
        EXPECT_GT(fragments, 20U) << entry.id;
    }
}

// More fragments than a stencil counts; all at one depth, so their order is that of submission.
TEST_F(LesserGl, LayersCaptureHundredsOfFragments) {
    Scene scene;
    scene.camera = {glm::vec3(0), 1.0f, 0.0f, 0.0f, 0.8f};
    scene.meshes = {make_rectangle(20.0f, 20.0f, 1, 1)};
    scene.objects.resize(700, {0, glm::mat4(1), glm::vec3(1), 0.01f});
    Renderer renderer(without_storage());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "unsorted", {8, 8}));
    const PixelCapture capture = renderer.capture_pixel({2, 3});
    ASSERT_EQ(capture.ray.fragments.size(), 700U);
    for (std::uint32_t i = 0; i < 700; ++i) EXPECT_EQ(capture.ray.fragments[i].draw, i);
}

// As in a browser, or with zink: what is said to be available can be drawn, with its parameters, too.
TEST_F(LesserGl, DrawsAllThatIsAvailable) {
    const auto programs = lesser([](Capabilities& gl) {
        gl.storage = gl.unorm16 = false;
        gl.ordered = OrderedAccess::none;
    });
    const Scene scene = load_scene("planes", 0.4f);
    Renderer renderer(programs);
    renderer.set_scene(scene);
    int missing = 0;
    for (const Configuration& configuration : chart_grid(ParameterValues())) {
        const View view = {scene.camera, {16, 9}, configuration.technique, configuration.values};
        if (why_unavailable(configuration, programs->gl()).empty()) {
            EXPECT_NO_THROW(renderer.render(view)) << configuration_text(configuration);
        } else {
            EXPECT_THROW(renderer.render(view), Error) << configuration_text(configuration);
            ++missing;
        }
    }
    EXPECT_GT(missing, 10);
}

// As in a browser: the layers are counted before they are peeled. No two planes share a depth, so every layer
// counts.
TEST_F(LesserGl, PeelsTheSameWithoutAnswersOfQueries) {
    const auto counting = lesser([](Capabilities& gl) { gl.storage = gl.answers_at_once = false; });
    for (const char* technique : {"peeling", "sorted"}) {
        const Scene scene = load_scene("planes", 0.4f);
        Renderer asks(without_storage()), counts(counting);
        for (Renderer* renderer : {&asks, &counts}) {
            renderer->set_scene(scene);
            renderer->render(view_of(scene, technique, {64, 36}));
        }
        EXPECT_EQ(asks.read_picture().pixels, counts.read_picture().pixels) << technique;
    }
}

// The same within one draw call: the numbers of triangles must ascend although the GL counts each part from
// 0.
TEST_F(LesserGl, LayersNumberTheTrianglesOfAMesh) {
    Scene scene;
    scene.camera = {glm::vec3(0), 1.0f, 0.0f, 0.0f, 0.8f};
    scene.meshes = {make_rectangle(20.0f, 20.0f, 1, 1)};
    const std::vector<std::uint32_t> once = scene.meshes[0].indices;
    for (int i = 1; i < 400; ++i)
        scene.meshes[0].indices.insert(scene.meshes[0].indices.end(), once.begin(), once.end());
    scene.objects = {{0, glm::mat4(1), glm::vec3(1), 0.01f}};
    Renderer renderer(without_storage());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "unsorted", {8, 8}));
    const auto fragments = renderer.capture_pixel({2, 3}).ray.fragments;
    ASSERT_EQ(fragments.size(), 400U);
    EXPECT_TRUE(std::ranges::is_sorted(fragments, std::ranges::less_equal(), &Fragment::primitive));
}

TEST_F(LesserGl, SortedPeelsWhereThereAreNoLists) {
    if (!shared_programs()->gl().storage) GTEST_SKIP() << "this GL has no lists";
    const auto programs = without_storage();
    for (const SceneEntry& entry : scene_entries()) {
        // Scenes with fragments at one depth, and with surfaces that cross.
        const bool usual = std::set<std::string>{"ties", "spheres", "foliage"}.contains(entry.id);
        if (!usual && effort(0, 1) == 0) continue;
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer lists(shared_programs()), layers(programs);
        for (Renderer* renderer : {&lists, &layers}) {
            renderer->set_scene(scene);
            renderer->render(view_of(scene, "sorted", {96, 54}));
        }
        const double difference = mean_difference(lists.read_picture(), layers.read_picture(), Metric::flip);
        RecordProperty(entry.id, fmt::format("{}", difference));
        EXPECT_LE(difference, 0.01) << entry.id;
        EXPECT_LE(differing_share(lists.read_picture(), layers.read_picture()), 0.02) << entry.id;
        if (entry.id == std::string("ties")) {
            EXPECT_LE(difference, 1e-6) << "fragments at one depth stay";
        }
    }
}

// Four targets a pass, ends in a pass of their own, and ends in floats give the same bits.
TEST_F(LesserGl, FewerTargetsGiveTheSamePictures) {
    const auto programs = lesser([](Capabilities& gl) {
        gl.color_targets = 4;
        gl.blending_per_target = gl.unorm16 = false;
    });
    const Scene scene = load_scene("teapots", 0.4f);
    Renderer whole(shared_programs()), lesser_gl(programs);
    whole.set_scene(scene);
    lesser_gl.set_scene(scene);
    for (const Technique& technique : techniques()) {
        if (!why_unavailable(technique, lesser_gl.gl()).empty() || technique.is_truth()) continue;
        // With ends in a pass of their own, with five texels of a factor, and with more than four of a state.
        const bool usual =
            std::set<std::string>{"certain4", "sharp8", "wavelet", "mlab"}.contains(technique.id);
        if (!usual && effort(0, 1) == 0) continue;
        const View view = view_of(scene, technique.id, {96, 54});
        whole.render(view);
        if (technique.id == std::string("mlab") &&
            lesser_gl.gl().ordered == OrderedAccess::framebuffer_fetch) {
            EXPECT_THROW(lesser_gl.render(view), Error) << "its states are read and written at once";
            continue;
        }
        lesser_gl.render(view);
        EXPECT_EQ(whole.read_picture().pixels, lesser_gl.read_picture().pixels) << technique.id;
    }
}

// llvmpipe is a driver that re-associates; others may not.
TEST_F(LesserGl, RoundingIsKeptWithAndWithoutPrecise) {
    const Dialect dialect = shared_programs()->gl().language.dialect;
    const Dialect without = dialect == Dialect::essl_300 ? dialect : Dialect::glsl_330;
    EXPECT_NE(kept_rounding(without), Rounding::lost);
    EXPECT_TRUE(keeps_rounding_errors({without, Rounding::guarded}));
    EXPECT_TRUE(keeps_rounding_errors(shared_programs()->gl().language));
}

GpuCheckPlan small_check() {
    return {.techniques = {&require_technique("trig3-32"), &require_technique("wboit"),
                           &require_technique("stochastic")}};
}

TEST_F(LesserGl, TheCheckFindsTheBitsOfCpp) {
    int steps = 0;
    const GpuCheck check = check_gpu(small_check(), shared_programs(), {}, [&] { ++steps; });
    EXPECT_EQ(steps, 3);
    EXPECT_TRUE(check.passed()) << gpu_check_text(check, "this");
    EXPECT_GT(check.techniques[0].fragments, 500);
    EXPECT_NE(gpu_check_verdict(check).find("have the bits of C++"), std::string::npos);
}

// A driver that breaks the order of operations: guards are left out where they are needed.
TEST_F(LesserGl, TheCheckSaysWhatOtherBitsMean) {
    if (kept_rounding(Dialect::essl_300 == shared_programs()->gl().language.dialect
                          ? Dialect::essl_300
                          : Dialect::glsl_330) != Rounding::guarded)
        GTEST_SKIP() << "this driver does not re-associate";
    const auto programs = lesser([](Capabilities& gl) {
        if (gl.language.dialect != Dialect::essl_300) gl.language.dialect = Dialect::glsl_330;
        gl.language.rounding = Rounding::lost;
        gl.storage = false;
        gl.ordered = OrderedAccess::none;
    });
    const GpuCheck check = check_gpu(small_check(), programs, {}, [] {});
    EXPECT_FALSE(check.passed());
    EXPECT_FALSE(check.has_same_bits());
    EXPECT_GT(check.techniques[0].different, 0);
    EXPECT_NE(gpu_check_verdict(check).find("rounds differently"), std::string::npos);
    EXPECT_NE(gpu_check_text(check, "this").find("missing: the order of floating-point operations"),
              std::string::npos);
    EXPECT_EQ(check.techniques[2].state, CheckState::unavailable) << "stochastic needs storage";
    EXPECT_NE(gpu_check_json(check, "this").find("\"same_bits\": false"), std::string::npos);
}

// What a check found without drawing anything: each fault alone must end it with exit code 1.
TEST(GpuCheckResult, PassesOnlyWithoutAnyFault) {
    GpuCheck check;
    check.techniques.resize(2);  // both were checked, and nothing differs
    EXPECT_TRUE(check.passed());
    GpuCheck wrong = check;
    wrong.techniques[1].picture_error = 2 * PICTURE_TOLERANCE;
    EXPECT_FALSE(wrong.passed());
    EXPECT_NE(gpu_check_verdict(wrong).find("which rounding does not explain"), std::string::npos);
    wrong.techniques[1].picture_error = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(wrong.passed()) << "a picture with NaN";
    wrong = check;
    wrong.techniques[0].state = CheckState::failed;
    EXPECT_FALSE(wrong.passed());
    EXPECT_NE(gpu_check_verdict(wrong).find("1 failed"), std::string::npos);
    wrong = check;
    wrong.techniques[0].state = wrong.techniques[1].state = CheckState::unavailable;
    EXPECT_EQ(gpu_check_verdict(wrong), "0 of 2 techniques run here.");
}

TEST_F(LesserGl, AStopEndsTheCheck) {
    std::stop_source stop;
    const GpuCheck check =
        check_gpu(small_check(), shared_programs(), stop.get_token(), [&] { stop.request_stop(); });
    EXPECT_EQ(check.techniques.size(), 1U);
}

}  // namespace
}  // namespace momentscope::test
