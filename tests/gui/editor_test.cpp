// editor_test.cpp -- the ray editor, the steps, and stress and tune in the background.
#include <cmath>
#include <cstdlib>

#include "core/inspect/pixel_color.hpp"
#include "core/ray/ray_presets.hpp"
#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {
namespace {

class EditorTest : public GuiTest {
protected:
    void open_preset(const char* id) {
        open("planes", "power6-32");
        play(fmt::format("click @tab.5\nclick @editor.preset\nclick @editor.preset.{}", id));
    }
    const std::vector<Fragment>& fragments() { return state().ray->fragments; }
    PixelColors colors() {
        return pixel_colors(measurement().capture.ray, measurement().history, *measurement().curve.technique,
                            measurement().curve.parameters, glm::vec3(0.2f));
    }
};

TEST_F(EditorTest, DraggingAFragmentAcrossAnotherChangesCurveTableAndColourAndIsOneStep) {
    open_preset("two");
    ASSERT_EQ(fragments().size(), 2u);
    const ui::ExplorerState before = state();
    const auto curve = measurement().curve.reconstructed;
    const auto first_in_front = measurement().history.front().fragment;
    const glm::vec3 color = colors().technique;
    const auto screen_before = screen();
    // Fragment 1 at z = -0.4 moves behind fragment 2 at 0.4.
    play("drag @editor.fragment.1 to @editor.area 0.9 0.3");
    EXPECT_NEAR(fragments()[0].depth, 0.8f, 0.02f);
    EXPECT_NEAR(fragments()[0].opacity, 0.7f, 0.02f);
    EXPECT_EQ(fragments()[0].view_depth, fragments()[0].depth) << "no depth warp";
    EXPECT_NE(measurement().curve.reconstructed, curve);
    EXPECT_NE(measurement().history.front().fragment, first_in_front) << "the table's order follows";
    EXPECT_GT(glm::length(colors().technique - color), 0.05f) << "the pixel has another colour";
    EXPECT_GT(changed("plot", screen_before, screen()), 500);
    EXPECT_GT(changed("editor.technique", screen_before, screen()), 50) << "and shows it";
    play("key Ctrl+Z");
    EXPECT_TRUE(state().ray == before.ray) << "the whole drag is one step";
    EXPECT_EQ(measurement().curve.reconstructed, curve);
    play("key Ctrl+Y");
    EXPECT_NEAR(fragments()[0].depth, 0.8f, 0.02f);
}

TEST_F(EditorTest, AddsMarksTypesAndDeletes) {
    open_preset("empty");
    EXPECT_TRUE(fragments().empty());
    play("doubleclick @editor.area 0.25 0.5\nwait 1\ndoubleclick @editor.area 0.75 0.25");
    ASSERT_EQ(fragments().size(), 2u);
    EXPECT_NEAR(fragments()[0].depth, -0.5f, 0.01f);
    EXPECT_NEAR(fragments()[0].opacity, 0.5f, 0.01f);
    EXPECT_NEAR(fragments()[1].opacity, 0.75f, 0.01f);
    play("wait 1\nclick @editor.fragment.1");
    EXPECT_EQ(state().marked, 0u);
    play("wait 1\ndoubleclick @editor.opacity\nkey Ctrl+A\ntype 0.125\nkey Enter");
    EXPECT_FLOAT_EQ(fragments()[0].opacity, 0.125f);
    play("wait 1\nclick @editor.fragment.2\nkey Delete");
    ASSERT_EQ(fragments().size(), 1u);
    EXPECT_FLOAT_EQ(fragments()[0].opacity, 0.125f);
    for (int i = 0; i < 20; ++i) play("key Ctrl+Z");
    EXPECT_FALSE(state().ray) << "undo goes on without limit, back to the scene";
}

TEST_F(EditorTest, DetachesThePickedPixelAndGoesBack) {
    open("teapots", "power6-32");
    const ViewRay picked = measurement().capture.ray;
    play("click @tab.5\nclick @editor.detach");
    ASSERT_TRUE(state().ray);
    EXPECT_EQ(*state().ray, picked);
    play("click @editor.leave");
    EXPECT_FALSE(state().ray);
    EXPECT_EQ(measurement().capture.ray, picked);
    // The first drag also detaches the ray from the scene.
    play("drag @editor.fragment.1 to @editor.area 0.5 0.5");
    ASSERT_TRUE(state().ray);
    EXPECT_EQ(state().ray->fragments.size(), picked.fragments.size());
    EXPECT_EQ(state().ray->fragments[0].depth,
              to_depth(state().ray->fragments[0].view_depth, state().ray->warp))
        << "so that a saved ray comes back the same";
}

TEST_F(EditorTest, CopiesAndPastesAndRefusesNonsense) {
    open_preset("four");
    play("click @editor.copy\nclick @editor.preset\nclick @editor.preset.one\nclick @editor.paste");
    EXPECT_EQ(fragments().size(), 4u);
    const auto before = state().ray;
    ImGui::SetClipboardText("{\"fragments\": 3}");
    play("click @editor.paste");
    EXPECT_TRUE(state().ray == before);
    EXPECT_NE(message(), "");
    std::string huge = "{\"fragments\": [";
    for (int i = 0; i < 1'000'000; ++i)
        huge += i == 0 ? "{\"depth\":0,\"opacity\":1}" : ",{\"depth\":0,\"opacity\":1}";
    ImGui::SetClipboardText((huge + "]}").c_str());
    play("click @editor.paste");
    EXPECT_TRUE(state().ray == before);
    EXPECT_NE(message().find("2000000 values"), std::string::npos) << message();
}

TEST_F(EditorTest, EveryPresetCanBeChosen) {
    for (const RayPreset& preset : ray_presets()) {
        open_preset(preset.id);
        EXPECT_EQ(*state().ray, preset.make()) << preset.id;
        EXPECT_EQ(message(), "");
    }
}

TEST_F(EditorTest, StepsFollowTheQueryForEveryBasis) {
    for (const char* id : {"power8-32", "trig3-32", "cheb6-32", "power4-16"}) {
        open("teapots", id);
        play("click @tab.4");
        EXPECT_TRUE(workspace().widget_rects.contains("steps.8")) << id;
        const auto before = screen();
        play("click @plot 0.3 0.5\nmove 5 5");
        EXPECT_GT(changed("panel", before, screen()), 50) << id << ": other numbers";
    }
    open("teapots", "sorted");
    play("click @tab.4");
    EXPECT_FALSE(workspace().widget_rects.contains("steps.8")) << "the truth has no steps, and says so";
}

TEST_F(EditorTest, StressRunsBesideTheWindowAndOpensAWorstRay) {
    open("planes", "power6-32");
    play("click @tab.6\nclick @stress.run");
    ASSERT_TRUE(workspace().widget_rects.contains("stress.power8-32.gap-1e-4"));
    play("click @stress.power8-32.gap-1e-4");
    ASSERT_TRUE(state().ray);
    EXPECT_EQ(state().ray->fragments.size(), 2u);
    EXPECT_NEAR(std::abs(state().ray->fragments[0].depth - state().ray->fragments[1].depth), 1e-4f, 1e-6f);
    EXPECT_STREQ(state().technique->id, "power8-32");
    EXPECT_EQ(state().panel, ui::Panel::editor);
}

TEST_F(EditorTest, TuneAppliesWhatItFindsAsOneStep) {
    open("planes", "power8-32");
    const ParameterValues before = state().parameters;
    play("click @controls.tune");
    EXPECT_NE(message().find("Tuned"), std::string::npos) << message();
    ASSERT_TRUE(state().parameters[ParameterId::alpha]);
    EXPECT_LT(*state().parameters[ParameterId::beta], 0.25f) << "four sheets need no overestimation";
    play("key Ctrl+Z");
    EXPECT_EQ(state().parameters, before);
}

}  // namespace
}  // namespace momentscope::test
