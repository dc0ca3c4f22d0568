// compare_test.cpp -- the picture and its reference in the window: actions of a user, and the expected
// results.
#include <nlohmann/json.hpp>

#include "core/inspect/color_uncertainty.hpp"
#include "tests/gui/compare_fixture.hpp"
#include "ui/model/comparison_map.hpp"
#include "ui/model/session.hpp"

namespace momentscope::test {
namespace {

using ui::CompareMode;

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

TEST_F(CompareTest, WhatTheMomentsLeaveOpenNeedsNoReference) {
    open("spheres", "power4-32");
    play("key Shift+H");
    const ui::FrameReport& report = workspace().report;
    EXPECT_FALSE(report.reference);
    const ui::Comparison& numbers = workspace().comparison.numbers();
    ASSERT_NE(numbers.uncertainty(), nullptr);
    EXPECT_EQ(numbers.uncertainty()->map, workspace().picture.renderer().uncertainty());
    const float published = numbers.uncertainty()->most;
    const auto rgba =
        ui::false_color_bytes(numbers.uncertainty()->map, OPEN_FULL_SCALE / state().compare.gain);
    const int width = measurement().picture_size.x;
    const Screen shown = screen();
    for (int y = BELOW_LABELS; y < measurement().picture_size.y; ++y)
        for (int x = 0; x < width; x += 7) {
            if (glm::distance(glm::vec2(x, y), glm::vec2(measurement().pixel)) < 20) continue;  // the mark
            const auto at = 4 * static_cast<std::size_t>(y * width + x);
            const std::array<int, 3> expected = {rgba[at], rgba[at + 1], rgba[at + 2]};
            ASSERT_EQ(color_of_pixel(shown, {x, y}), expected) << x << ", " << y;
        }
    draw();
    EXPECT_FALSE(report.comparison) << "nothing changed";
    workspace().state.compare.gain = 8;
    draw();
    EXPECT_TRUE(report.comparison);
    EXPECT_FALSE(report.second_pass);
    workspace().state.technique = &require_technique("sharp8");
    draw();
    EXPECT_LT(numbers.uncertainty()->most, published);
    workspace().state.technique = &require_technique("wboit");
    draw();
    EXPECT_NE(workspace().scene_picture.title.find("no moments"), std::string::npos);
    EXPECT_EQ(workspace().scene_picture.texture, workspace().picture.renderer().display_texture());
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
