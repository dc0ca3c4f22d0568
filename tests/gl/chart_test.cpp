// chart_test.cpp -- charts of real pictures: repeatable numbers repeat, a stopped chart continues, and times
// are measured.
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/bench/chart_run.hpp"
#include "core/bench/held_out.hpp"
#include "core/chart/camera_path.hpp"
#include "core/chart/chart.hpp"
#include "core/chart/grid.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class ChartTest : public GlTest<> {};

ChartPlan small_plan(const std::vector<const char*>& configurations) {
    ChartPlan plan;
    plan.scenes = {"planes", "spheres"};
    for (const char* text : configurations) plan.configurations.push_back(parse_configuration(text));
    plan.settings.size = {48, 27};
    plan.settings.repeat = 2;
    return plan;
}

ChartHooks quiet_hooks() {
    return {[](const std::string& id) { return load_scene(id, 0.4f); }, [](const RunTable&) {},
            [](std::size_t, std::size_t) {}};
}

RunTable nothing_of(const ChartPlan& plan) {
    return {chart_settings(plan, gl_info(shared_programs()->gl())), {}, {}};
}

RunTable run(const ChartPlan& plan) {
    return run_chart(plan, nothing_of(plan), {}, quiet_hooks());
}

/// The rows without times.
std::vector<ChartRow> errors_of(const RunTable& table) {
    std::vector<ChartRow> rows = chart_of(table, "the test").rows;
    for (ChartRow& row : rows)
        if (row.numbers)
            for (Spread ChartNumbers::*time :
                 {&ChartNumbers::moments, &ChartNumbers::color, &ChartNumbers::composite,
                  &ChartNumbers::total, &ChartNumbers::differential})
                *row.numbers.*time = {};
    return rows;
}

TEST_F(ChartTest, ErrorsRepeatAndTimesAreTaken) {
    const ChartPlan plan =
        small_plan({"unsorted", "sorted", "power4-32", "hashed", "mt:resolution=half", "peeling"});
    const RunTable first = run(plan);
    EXPECT_EQ(errors_of(first), errors_of(run(plan)));
    const Chart chart = chart_of(first, "the test");
    ASSERT_EQ(chart.rows.size(), 12U);
    for (const ChartRow& row : chart.rows) {
        ASSERT_TRUE(row.numbers) << row.unavailable;
        EXPECT_GT(row.numbers->total.median, 0) << row.configuration;
        EXPECT_GE(row.numbers->total.range, 0) << row.configuration;
        const bool truth = row.configuration == "sorted";
        if (truth) {
            EXPECT_EQ(row.numbers->rmse, 0);
            EXPECT_EQ(row.numbers->stability, 0);
        }
    }
    EXPECT_GT(chart.rows[0].numbers->rmse, chart.rows[2].numbers->rmse)
        << "unsorted is worse than four moments";
    EXPECT_EQ(chart.rows[2].numbers->stored_bits, 160);
    EXPECT_EQ(chart.rows[2].numbers->bits_with_factor, 160);
    EXPECT_EQ(chart.rows[1].numbers->bits_with_factor, std::nullopt) << "grows";
}

TEST_F(ChartTest, GoesOnWhereItWasEnded) {
    ChartPlan plan = small_plan(
        {"unsorted", "wboit", "wboit:weight=g3d", "hashed", "mlab", "mlab:layers=2", "fourier", "power4-32"});
    std::stop_source stop;
    std::vector<RunTable> kept;
    ChartHooks hooks = quiet_hooks();
    hooks.keep = [&](const RunTable& table) {
        kept.push_back(table);
        stop.request_stop();
    };
    const RunTable ended = run_chart(plan, nothing_of(plan), stop.get_token(), hooks);
    ASSERT_EQ(kept.size(), 1U);
    ASSERT_GT(ended.rows.size(), 0U);
    ASSERT_LT(ended.rows.size(), 16U);
    std::size_t measured = 0;
    hooks = quiet_hooks();
    hooks.progress = [&](std::size_t, std::size_t all) { measured = all; };
    const RunTable whole = run_chart(plan, kept.back(), {}, hooks);
    ASSERT_EQ(whole.rows.size(), 16U);
    EXPECT_EQ(measured, chart_steps(16 - ended.rows.size(), plan.settings)) << "and nothing twice";
    for (std::size_t i = 0; i < ended.rows.size(); ++i)
        EXPECT_EQ(whole.rows[i], ended.rows[i]) << "with its times";
    EXPECT_EQ(errors_of(whole), errors_of(run(plan)));
}

TEST_F(ChartTest, ShardsHaveTheErrorsOfTheWhole) {
    ChartPlan plan = small_plan({"unsorted", "wboit", "power4-32", "at"});
    const std::vector<ChartRow> whole = errors_of(run(plan));
    std::size_t rows = 0;
    for (int i = 1; i <= 3; ++i) {
        plan.shard = {i, 3};
        const std::vector<ChartRow> part = errors_of(run(plan));
        for (std::size_t j = 0; j < part.size(); ++j)
            EXPECT_EQ(part[j], whole[j * 3 + static_cast<std::size_t>(i) - 1]);
        rows += part.size();
    }
    EXPECT_EQ(rows, whole.size());
}

TEST_F(ChartTest, StoppedBeforeItBeganIsEmpty) {
    std::stop_source stop;
    stop.request_stop();
    const ChartPlan plan = small_plan({"wboit"});
    EXPECT_TRUE(run_chart(plan, nothing_of(plan), stop.get_token(), quiet_hooks()).rows.empty());
}

/// A scene with transparent surfaces of this colour.
ChartHooks bright_hooks(float brightness) {
    ChartHooks hooks = quiet_hooks();
    hooks.load = [brightness](const std::string& id) {
        Scene scene = load_scene(id, 0.4f);
        for (Object& object : scene.objects)
            if (!object.opaque()) object.color = glm::vec3(brightness);
        return scene;
    };
    return hooks;
}

TEST_F(ChartTest, PicturesThatAreNoNumbersHaveNoErrors) {
    ChartPlan plan = small_plan({"power4-32", "sorted"});
    plan.scenes = {"planes"};
    plan.settings.repeat = 1;
    const ChartHooks infinite = bright_hooks(std::numeric_limits<float>::infinity());
    for (const ChartRow& row : chart_of(run_chart(plan, nothing_of(plan), {}, infinite), "the test").rows)
        EXPECT_NE(row.unavailable.find("pixels of the picture by sorted are infinite or NaN"),
                  std::string::npos)
            << row.unavailable;
    HeldOutViews views(infinite.load("planes"), plan.settings.size, {});
    EXPECT_THROW(views.error(plan.configurations[0], 0, Metric::flip), Error);
}

TEST_F(ChartTest, RedrawingRunsEveryStageButTheOpaqueOneAndChangesNothing) {
    const Scene scene = load_scene("planes", 0.4f);
    Renderer renderer(shared_programs());
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "power4-32", {48, 27}));
    const Image picture = renderer.read_picture();
    const PassCounts before = renderer.pass_counts();
    renderer.redraw();
    EXPECT_EQ(renderer.read_picture().pixels, picture.pixels);
    const PassCounts& after = renderer.pass_counts();
    EXPECT_EQ(after.opaque, before.opaque);
    EXPECT_EQ(after.moments, before.moments + 1);
    EXPECT_EQ(after.color, before.color + 1);
    EXPECT_EQ(after.composite, before.composite + 1);
}

TEST_F(ChartTest, SoftwareIsTimedByTheClock) {
    GlInfo gl;
    gl.software = true;
    EXPECT_EQ(reliable_timing(gl), PassTiming::finish);
    gl.software = false;
    EXPECT_EQ(reliable_timing(gl), PassTiming::finish) << "there are no timer queries";
    gl.can.timer_queries = true;
    EXPECT_EQ(reliable_timing(gl), PassTiming::queries);
    EXPECT_EQ(Renderer().pass_timing(), reliable_timing(gl_info(shared_programs()->gl())));
}

TEST(CameraPath, TurnsEvenlyAboutTheCamera) {
    Camera camera;
    camera.azimuth = 0.7f;
    const std::vector<Camera> path = camera_path(camera);
    ASSERT_EQ(path.size(), static_cast<std::size_t>(PATH_FRAMES));
    EXPECT_NEAR(0.5f * (path.front().azimuth + path.back().azimuth), camera.azimuth, 1e-6f);
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_NEAR(path[i].azimuth - path[i - 1].azimuth, 0.5f * std::numbers::pi_v<float> / 180, 1e-6f);
}

}  // namespace
}  // namespace momentscope::test
