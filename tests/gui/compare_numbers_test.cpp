// compare_numbers_test.cpp -- the metrics of picture and reference in the window, and the worst pixels.
#include <cmath>
#include <set>

#include "tests/gui/compare_fixture.hpp"

namespace momentscope::test {
namespace {

/// The first pixel with the greatest value among those that are at least `distance` away from all others.
glm::ivec2 worst_of(const std::vector<float>& map, int width, const std::vector<glm::ivec2>& others = {}) {
    glm::ivec2 worst(-1);
    float most = -1;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const glm::ivec2 pixel(static_cast<int>(i) % width, static_cast<int>(i) / width);
        const bool near = std::ranges::any_of(
            others, [&](glm::ivec2 other) { return std::hypot(pixel.x - other.x, pixel.y - other.y) < 16; });
        if (near || map[i] <= most) continue;
        most = map[i];
        worst = pixel;
    }
    return worst;
}

TEST_F(CompareTest, TheTableHasWhatCoreCompareSays) {
    open("spheres", "power4-32");
    play("key Ctrl+7");
    const Image reference = drawn_by("sorted");
    const Image picture = window_->renderer().read_picture();
    for (const MetricRow& row : metrics()) {
        ASSERT_TRUE(workspace().comparison.numbers().is_fresh(row.id)) << row.key;
        const ui::MetricResult& result = *workspace().comparison.numbers().result(row.id);
        EXPECT_EQ(result.mean, mean_difference(reference, picture, row.id)) << row.key;
        EXPECT_EQ(result.worst, worst_of(result.map, picture.width)) << row.key;
        EXPECT_GT(result.mean, 0);
    }
}

TEST_F(CompareTest, ADraggedRegionHasNumbersOfItsOwn) {
    open("spheres", "power4-32");
    const auto picked = measurement().pixel;
    play("hold Shift\ndrag " + on_scene({260, 300}) + " to " + on_scene({359, 339}) +
         "\nlet Shift\nmove -10 -10");
    ASSERT_TRUE(state().compare.region);
    EXPECT_EQ(state().panel, ui::Panel::compare) << "that is where its numbers are";
    EXPECT_EQ(measurement().pixel, picked);
    const glm::ivec2 size = measurement().picture_size;
    const PixelRegion region = ui::pixels_of(state().compare.region, size);
    EXPECT_EQ(region, (PixelRegion{260, 300, 100, 40}));
    const Screen one = screen();
    play("hold Shift\ndrag " + on_scene({10, 120}) + " to " + on_scene({120, 30}) +
         "\nlet Shift\nmove -10 -10");
    EXPECT_EQ(ui::pixels_of(state().compare.region, size), (PixelRegion{10, 30, 111, 91}));
    EXPECT_GT(changed("comparison.metric.rmse", one, screen()), 20);
    const Screen other = screen();
    play("key Escape\nmove -10 -10");
    EXPECT_FALSE(state().compare.region);
    EXPECT_GT(changed("comparison.metric.rmse", other, screen()), 20);
    play("key Ctrl+Z");
    EXPECT_TRUE(state().compare.region);
    play("hold Shift\nclick " + on_scene({200, 200}) + "\nlet Shift");
    EXPECT_FALSE(state().compare.region) << "a click with Shift forgets it, too";
}

TEST_F(CompareTest, NumbersOfARegionAreItsMean) {
    open("spheres", "power4-32");
    play("key Ctrl+7");
    ui::Comparison comparison;
    comparison.set_pair({drawn_by("sorted"), window_->renderer().read_picture()});
    const ui::MetricResult& result = *workspace().comparison.numbers().result(Metric::rmse);
    const PixelRegion region = {260, 300, 100, 40};
    double sum = 0;
    for (int y = 300; y < 340; ++y)
        for (int x = 260; x < 360; ++x)
            sum += std::pow(static_cast<double>(
                                result.map[static_cast<std::size_t>(y * measurement().picture_size.x + x)]),
                            2);
    EXPECT_NEAR(comparison.mean_of(result, region), std::sqrt(sum / 4000), 1e-9);
    EXPECT_GT(std::abs(comparison.mean_of(result, region) - result.mean), 1e-4);
}

TEST_F(CompareTest, TheNextWorstPixelIsTrulyTheWorst) {
    open("spheres", "power4-32");
    const std::vector<float> map = map_of("sorted", Metric::rmse);
    const int width = measurement().picture_size.x;
    std::vector<glm::ivec2> seen;
    for (int i = 1; i <= 4; ++i) {
        play("key J");
        EXPECT_EQ(measurement().pixel, worst_of(map, width, seen)) << "jump " << i;
        EXPECT_NE(message().find(fmt::format("Worst pixel {}: RMSE", i)), std::string::npos) << message();
        EXPECT_FALSE(measurement().capture.ray.fragments.empty()) << "the plot shows its ray";
        seen.push_back(measurement().pixel);
    }
    play("key 2");  // another picture: the sequence starts again
    const std::vector<float> other = map_of("sorted", Metric::rmse);
    play("key J");
    EXPECT_EQ(measurement().pixel, worst_of(other, width));
    // With another metric, by the button.
    play("key Ctrl+7\nclick @comparison.metric.flip\nclick @comparison.next_worst");
    EXPECT_EQ(measurement().pixel, worst_of(map_of("sorted", Metric::flip), width));
    // Within a region.
    play("hold Shift\ndrag " + on_scene({300, 300}) + " to " + on_scene({330, 330}) + "\nlet Shift\nkey J");
    const PixelRegion region = ui::pixels_of(state().compare.region, measurement().picture_size);
    EXPECT_TRUE(region.contains(measurement().pixel));
}

// A user goes to the worst pixel and reads why it is wrong. Turning down the harmful bias takes the blame
// away from it.
TEST_F(CompareTest, TheVerdictOnTheWorstPixelNamesItsCause) {
    ui::ExplorerState state_at_first;
    state_at_first.scene = "planes";
    state_at_first.technique = &require_technique("power8-32");  // enough moments for the planes
    state_at_first.parameters.set(ParameterId::alpha, 0.1f);
    state_at_first.compare.mode = ui::CompareMode::difference;
    open(state_at_first);
    play("key J\nclick @tab.2");
    ASSERT_GT(workspace().widget_rects.count("fragments.verdict"), 0U) << "is shown";
    const ErrorBreakdown biased = measurement().breakdown;
    EXPECT_GT(biased.error, 0.005);
    EXPECT_NE(biased.sentence.find("mostly because of the moment bias"), std::string::npos)
        << biased.sentence;
    play("click @tab.1\nclick @parameter.alpha.auto\nclick @tab.2");
    EXPECT_LT(measurement().breakdown.error, 0.5 * biased.error) << measurement().breakdown.sentence;
}

TEST_F(CompareTest, WhereNothingDiffersItSaysSo) {
    open("spheres", "sorted");
    const auto picked = measurement().pixel;
    play("key J");
    EXPECT_EQ(measurement().pixel, picked);
    EXPECT_NE(message().find("reference itself"), std::string::npos) << message();
    for (const char* event : {"key W", "key M", "key H", "key Ctrl+7", "hold G", "let G"}) play(event);
    EXPECT_FALSE(workspace().comparison.numbers().has_pair()) << "and nothing is computed";
    play("key 1\nhold Shift\ndrag " + on_scene({2, 2}) + " to " + on_scene({12, 12}) + "\nlet Shift\nkey J");
    EXPECT_NE(message().find("No pixel of the region differs"), std::string::npos) << message();
}

TEST_F(CompareTest, MetricsAreComputedBesideTheWindow) {
    open("teapots", "power6-32");
    EXPECT_FALSE(ui::has_background_work(workspace()));
    workspace().state.panel = ui::Panel::compare;
    draw();
    EXPECT_TRUE(ui::has_background_work(workspace())) << "the frame did not wait";
    EXPECT_EQ(workspace().comparison.numbers().result(Metric::flip), nullptr);
    settle();
    EXPECT_FALSE(ui::has_background_work(workspace()));
    EXPECT_TRUE(workspace().comparison.numbers().is_fresh(Metric::flip));
    const long before = log_.frames();
    play("wait 60");
    EXPECT_EQ(log_.frames(), before) << "then it is idle";
    // Nobody looks at the comparison any more, so unfinished work is given up.
    play("key 1");
    workspace().state.panel = ui::Panel::controls;
    settle();
    EXPECT_FALSE(ui::has_background_work(workspace()));
}

}  // namespace
}  // namespace momentscope::test
