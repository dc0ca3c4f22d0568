// compare_test.cpp -- picture and reference in the window: actions of a user, and the expected results.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/compare/difference.hpp"
#include "core/scene/scenes.hpp"
#include "tests/gui/gui_fixture.hpp"
#include "ui/model/comparison_map.hpp"
#include "ui/model/session.hpp"

namespace momentscope::test {
namespace {

using ui::CompareMode;
using Screen = std::vector<unsigned char>;

constexpr int BELOW_LABELS = 100;  // pixels from the top of the picture

class CompareTest : public GuiTest {
protected:
    /// The picture of the window's view with another technique, drawn separately.
    Image drawn_by(const char* technique) {
        const Scene scene = load_scene(state().scene, 1);
        Renderer renderer;
        renderer.set_scene(scene);
        renderer.render({workspace().camera(), measurement().picture_size, &require_technique(technique),
                         state().parameters});
        return renderer.read_picture();
    }
    std::vector<float> map_of(const char* reference, Metric metric) {
        return difference_map(drawn_by(reference), window_->renderer().read_picture(), metric);
    }

    /// The number of pixels that differ between these fractions of the picture's width, below the labels.
    long differing(const Screen& a, const Screen& b, float from, float to) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        const float width = rect.high.x - rect.low.x;
        long count = 0;
        for (int y = static_cast<int>(rect.low.y) + BELOW_LABELS; y < static_cast<int>(rect.high.y); ++y)
            for (int x = static_cast<int>(rect.low.x + from * width);
                 x < static_cast<int>(rect.low.x + to * width); ++x)
                count += color(a, x, y) == color(b, x, y) ? 0 : 1;
        return count;
    }
    std::array<int, 3> color(const Screen& screen, int x, int y) {
        const auto at = 4 * static_cast<std::size_t>(y * size_.x + x);
        return {screen[at], screen[at + 1], screen[at + 2]};
    }
    std::array<int, 3> color_of_pixel(const Screen& screen, glm::ivec2 pixel) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        return color(screen, static_cast<int>(rect.low.x) + pixel.x, static_cast<int>(rect.low.y) + pixel.y);
    }

    /// A region in the row of labels, and whether it differs.
    bool labels_differ(const Screen& a, const Screen& b, float from, float to) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        const float width = rect.high.x - rect.low.x;
        for (int y = static_cast<int>(rect.low.y) + 5; y < static_cast<int>(rect.low.y) + 30; ++y)
            for (int x = static_cast<int>(rect.low.x + from * width);
                 x < static_cast<int>(rect.low.x + to * width); ++x)
                if (color(a, x, y) != color(b, x, y)) return true;
        return false;
    }
    Screen flipped() {
        play("hold G");
        Screen result = screen();
        play("let G");
        return result;
    }
};

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

TEST_F(CompareTest, AWipeShowsTheReferenceOnOneSide) {
    open("spheres", "power4-32");
    const Screen picture = screen();
    const Screen reference = flipped();
    ASSERT_GT(differing(picture, reference, 0, 0.48f), 1000);
    ASSERT_GT(differing(picture, reference, 0.52f, 1), 1000);
    play("key W");
    EXPECT_EQ(state().compare.mode, CompareMode::wipe);
    EXPECT_EQ(differing(screen(), reference, 0, 0.48f), 0);
    EXPECT_EQ(differing(screen(), picture, 0.52f, 1), 0);
    play("drag @scene.divider to @scene 0.75 0.5\nmove -10 -10");
    EXPECT_NEAR(state().compare.divider, 0.75f, 0.01f);
    EXPECT_FALSE(state().picked) << "who drags the line picks no pixel";
    EXPECT_EQ(differing(screen(), reference, 0, 0.73f), 0);
    EXPECT_EQ(differing(screen(), picture, 0.77f, 1), 0);
    play("drag @scene.divider to -500 300\nmove -10 -10");
    EXPECT_EQ(state().compare.divider, ui::MIN_DIVIDER) << "the line stays within reach";
    play("key Ctrl+Z");
    EXPECT_NEAR(state().compare.divider, 0.75f, 0.01f) << "a drag is one step";
    play("click @scene.wipe\nmove -10 -10");
    EXPECT_EQ(screen(), picture);
}

TEST_F(CompareTest, SwapExchangesSidesAndLabels) {
    open("spheres", "power4-32");
    const Screen picture = screen();
    const Screen reference = flipped();
    play("key W");
    const Screen wiped = screen();
    play("key Shift+W");
    const Screen swapped = screen();
    EXPECT_EQ(differing(swapped, picture, 0, 0.48f), 0);
    EXPECT_EQ(differing(swapped, reference, 0.52f, 1), 0);
    EXPECT_TRUE(labels_differ(wiped, swapped, 0, 0.3f));
    EXPECT_TRUE(labels_differ(wiped, swapped, 0.7f, 1));
    play("key Ctrl+7\nclick @comparison.swap\nkey Ctrl+1\nmove -10 -10");
    EXPECT_EQ(screen(), wiped);
}

TEST_F(CompareTest, FlippingShowsTheChosenReference) {
    open("spheres", "power4-32");
    play("key Ctrl+7\nclick @comparison.reference\nclick @comparison.reference.wboit\nmove -10 -10");
    EXPECT_EQ(std::string(state().compare.reference->id), "wboit");
    const Screen reference = flipped();
    open("spheres", "wboit");
    EXPECT_EQ(differing(screen(), reference, 0, 1), 0);
    play("key Shift+G");
    EXPECT_EQ(state().compare.reference, state().technique) << "and is taken as one by a key";
    EXPECT_EQ(differing(flipped(), reference, 0, 1), 0);
}

TEST_F(CompareTest, ADifferenceIsThatOfTheLinearChannelsAmplified) {
    open("spheres", "power4-32");
    play("key M");
    const Image reference = drawn_by("sorted");
    const Image picture = window_->renderer().read_picture();
    const Screen shown = screen();
    long bright = 0;
    for (int y = BELOW_LABELS; y < picture.height; ++y)
        for (int x = 0; x < picture.width; x += 7) {
            if (glm::distance(glm::vec2(x, y), glm::vec2(measurement().pixel)) < 20) continue;  // the mark
            const auto color = color_of_pixel(shown, {x, y});
            for (int c = 0; c < 3; ++c) {
                const float difference = std::abs(picture.at(x, y)[c] - reference.at(x, y)[c]);
                const int expected = static_cast<int>(
                    std::lround(255 * srgb_from_linear(std::min(state().compare.gain * difference, 1.0f))));
                ASSERT_NEAR(color[static_cast<std::size_t>(c)], expected, 1) << x << ", " << y;
                bright += expected > 60 ? 1 : 0;
            }
        }
    EXPECT_GT(bright, 500);
    play("key Ctrl+7\ndrag @comparison.gain 0.3 0.5 to @comparison.gain 1 0.5\nmove -10 -10");
    EXPECT_EQ(state().compare.gain, ui::MAX_GAIN);
    EXPECT_GT(differing(screen(), shown, 0, 1), 500);
}

TEST_F(CompareTest, FalseColorsAreThoseOfTheMetric) {
    open("spheres", "power4-32");
    play("key H\nkey Ctrl+7\nclick @comparison.metric.delta-e\nmove -10 -10");
    EXPECT_EQ(state().compare.metric, Metric::delta_e);
    const std::vector<float> map = map_of("sorted", Metric::delta_e);
    const auto rgba = ui::false_color_bytes(map, ui::false_color_end(state().compare));
    const int width = measurement().picture_size.x;
    const Screen shown = screen();
    std::set<std::array<int, 3>> colors;
    for (int y = BELOW_LABELS; y < measurement().picture_size.y; ++y)
        for (int x = 0; x < width; x += 7) {
            if (glm::distance(glm::vec2(x, y), glm::vec2(measurement().pixel)) < 20) continue;
            const auto at = 4 * static_cast<std::size_t>(y * width + x);
            const std::array<int, 3> expected = {rgba[at], rgba[at + 1], rgba[at + 2]};
            ASSERT_EQ(color_of_pixel(shown, {x, y}), expected) << x << ", " << y;
            colors.insert(expected);
        }
    EXPECT_GT(colors.size(), 20u);
    const auto& ramp = ui::false_colors();
    EXPECT_LT(ramp.front()[0] + ramp.front()[1] + ramp.front()[2], 20);
    EXPECT_GT(ramp.back()[0] + ramp.back()[1] + ramp.back()[2], 500);
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

TEST_F(CompareTest, TheReferenceIsDrawnOnlyForThoseWhoLook) {
    open("spheres", "power4-32");
    play("key 2");
    EXPECT_FALSE(workspace().report.reference);
    const ui::FrameReport& report = workspace().report;
    play("key W");
    workspace().state.technique = &require_technique("trig2-32");
    draw();
    EXPECT_TRUE(report.first_pass);
    EXPECT_FALSE(report.reference) << "it does not depend on the technique";
    workspace().state.compare.reference = &require_technique("peeling");
    draw();
    EXPECT_TRUE(report.reference);
    EXPECT_FALSE(report.first_pass);
}

TEST_F(CompareTest, TheLensZoomsUntilAllDigitsAreThere) {
    open("spheres", "power4-32");
    play("key L");
    const Camera camera = workspace().camera();
    const Screen values = screen();
    play("hold Ctrl\nmove " + on_scene({300, 100}) + "\nwheel 1\nlet Ctrl\nmove -10 -10");
    EXPECT_EQ(state().lens_zoom, ui::LensZoom::digits);
    EXPECT_EQ(workspace().camera(), camera);
    EXPECT_GT(changed("scene", values, screen()), 0);
    play("key Shift+L");
    EXPECT_EQ(state().lens_zoom, ui::LensZoom::far) << "and from the start again";
    play("key Shift+L\nkey Shift+L\nmove -10 -10");
    EXPECT_EQ(screen(), values);
    // The lens magnifies the visible pixels: at its smallest zoom, the middle cell has the colour of the
    // picked pixel.
    play("key Shift+L\nkey Shift+L\nkey J\nkey Escape\nkey M\nmove -10 -10");
    ASSERT_EQ(state().lens_zoom, ui::LensZoom::far);
    const Screen lens_of_difference = screen();
    play("key M\nmove -10 -10");
    const ui::Rect rect = workspace().widget_rects.at("scene");
    const auto in_lens = [&](const Screen& of) {
        return color(of, static_cast<int>(rect.low.x) + 20, static_cast<int>(rect.high.y) - 20);
    };
    EXPECT_NE(in_lens(lens_of_difference), in_lens(screen()));
}

TEST_F(CompareTest, ASessionKeepsTheComparison) {
    open("spheres", "power4-32");
    play(
        "key Ctrl+7\nclick @comparison.reference\nclick @comparison.reference.mlab\nkey W\n"
        "drag @scene.divider to @scene 0.3 0.5\nkey Shift+W\nclick @comparison.metric.flip\nkey L\nkey Shift+L\n"
        "hold Shift\ndrag @scene 0.6 0.2 to @scene 0.8 0.4\nlet Shift\nmove -10 -10");
    const ui::ExplorerState saved = state();
    EXPECT_EQ(saved.compare.mode, CompareMode::wipe);
    EXPECT_TRUE(saved.compare.swapped);
    EXPECT_TRUE(saved.compare.region);
    const Screen first = screen();
    open(ui::session_from_json(ui::session_to_json(saved).dump()).state);
    play("move -10 -10");
    EXPECT_EQ(state(), saved);
    EXPECT_EQ(screen(), first);
}

}  // namespace
}  // namespace momentscope::test
