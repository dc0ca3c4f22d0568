// plot_test.cpp -- mouse actions in the plot, and the plot's notes.
#include "tests/gui/gui_fixture.hpp"
#include "ui/model/series.hpp"
#include "ui/plot/plot_notes.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/widgets/parameter_controls.hpp"

namespace momentscope::test {
namespace {

class PlotTest : public GuiTest {
protected:
    /// The axes as currently drawn.
    ui::PlotAxes axes() {
        ui::PlotAxes a =
            ui::make_axes(measurement().capture.ray, measurement().curve, state().plot, {}, false);
        a.area = workspace().widget_rects.at("plot");
        return a;
    }
};

TEST_F(PlotTest, TheWheelZoomsAtTheMouse) {
    open("teapots", "power6-32");
    play("move @plot 0.25 0.5");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float depth = axes().depth_at(mouse.x);
    const float value = axes().value_at(mouse.y);
    play("wheel 3");
    ASSERT_TRUE(state().plot.depth);
    ASSERT_TRUE(state().plot.value);
    EXPECT_LT(state().plot.depth->high - state().plot.depth->low, 1.5f);
    EXPECT_NEAR(axes().depth_at(mouse.x), depth, 1e-4f) << "what is under the mouse stays there";
    EXPECT_NEAR(axes().value_at(mouse.y), value, 1e-3f);
    play("wheel -100\nwheel 100\nwheel 100\nwheel 100\nwheel 100");  // no overflow and no division by zero
    EXPECT_GT(axes().depth.high, axes().depth.low);
    play("doubleclick @plot 0.5 0.5");
    EXPECT_FALSE(state().plot.depth || state().plot.value);
}

TEST_F(PlotTest, AnAxisZoomsAndPansAlone) {
    open("teapots", "power6-32");
    play("move @plot.depth_axis\nwheel 2");
    EXPECT_TRUE(state().plot.depth);
    EXPECT_FALSE(state().plot.value);
    play("doubleclick @plot.depth_axis");
    EXPECT_FALSE(state().plot.depth);
    play("drag @plot.value_axis to @plot.value_axis 0.5 0.8");
    EXPECT_FALSE(state().plot.depth);
    ASSERT_TRUE(state().plot.value);
    EXPECT_GT(state().plot.value->low, 0);
    play("doubleclick @plot.value_axis");
    EXPECT_FALSE(state().plot.value);
}

TEST_F(PlotTest, RightDragPansAsTheMouseMoves) {
    open("teapots", "power6-32");
    const ui::PlotAxes before = axes();
    play("drag @plot 0.5 0.5 to @plot 0.6 0.5 right");
    ASSERT_TRUE(state().plot.depth);
    EXPECT_NEAR(state().plot.depth->low, before.depth.low - 0.1f * (before.depth.high - before.depth.low),
                5e-3f);
}

TEST_F(PlotTest, LeftDragMovesTheQuery) {
    open("teapots", "trig3-32");
    play("drag @plot 0.2 0.2 to @plot 0.8 0.2");
    ASSERT_TRUE(state().plot.query);
    EXPECT_NEAR(*state().plot.query,
                axes().depth_at(axes().area.low.x + 0.8f * (axes().area.high.x - axes().area.low.x)), 0.01f);
    EXPECT_EQ(measurement().canonical.query, *state().plot.query);
    play("drag @plot 0.5 0.2 to 5000 300");
    EXPECT_EQ(*state().plot.query, 1) << "it stays within the depth range";
}

TEST_F(PlotTest, LegendEntriesHideAndHighlight) {
    open("planes", "trig2-32");
    for (std::size_t i = 0; i < ui::SERIES_COUNT; ++i) {
        const std::string entry = fmt::format("@legend.{}", ui::series_rows()[i].key);
        const bool shown = state().plot.shown[i];
        if (!shown) play("click " + entry);
        play("move -10 -10");
        const auto with = screen();
        play("move " + entry);
        EXPECT_GT(changed("plot", with, screen()), 20) << entry << " is highlighted";
        play("click " + entry + "\nmove -10 -10");
        EXPECT_GT(changed("plot", with, screen()), 20) << entry << " is hidden";
        EXPECT_FALSE(state().plot.shown[i]);
        if (shown) play("click " + entry);
    }
}

TEST_F(PlotTest, TransmittanceAndViewDepthAreTheSameRay) {
    open("teapots", "power6-32");
    const ui::PlotAxes absorbance = axes();
    play("click @plot.transmittance");
    EXPECT_NEAR(axes().shown(2), std::exp(-2.0f), 1e-6f);
    EXPECT_LE(axes().value.high, 1.1f);
    play("click @plot.view");
    const DepthWarp& warp = measurement().capture.ray.warp;
    EXPECT_NEAR(axes().depth.low, warp.z_min, 1e-4f * warp.z_min);
    EXPECT_NEAR(axes().depth.high, warp.z_max, 1e-4f * warp.z_max);
    EXPECT_NEAR(axes().warped_of(axes().axis_of(0.3f)), 0.3f, 1e-4f);
    play("click @plot.absorbance\nclick @plot.warped");
    EXPECT_EQ(axes().value, absorbance.value);
}

TEST_F(PlotTest, ARayWithoutWarpHasNoViewDepth) {
    ui::ExplorerState state_with_ray;
    state_with_ray.ray = ViewRay{.fragments = {{-0.2f, -0.2f, 0.5f}, {0.4f, 0.4f, 0.7f}}, .warp = {}};
    open(state_with_ray);
    play("click @plot.view");
    EXPECT_EQ(state().plot.axis, ui::DepthAxis::warped) << "disabled";
}

// The truth leaves the bounds of the *biased* moments, and the note says why. For trigonometric moments the
// note says that these are not bounds at all.
TEST_F(PlotTest, TheNoteTellsWhyTheTruthLeavesTheBand) {
    ui::ExplorerState biased;
    biased.ray = ViewRay{.fragments = {{-0.9f, -0.9f, 0.3f}, {-0.85f, -0.85f, 0.3f}, {-0.8f, -0.8f, 0.3f}},
                         .warp = {}};
    biased.technique = &require_technique("power6-32");
    biased.parameters.set(ParameterId::alpha, 0.1f);
    open(biased);
    ASSERT_FALSE(measurement().exit.where.empty());
    EXPECT_NE(ui::band_note(measurement()).find("for the biased moments"), std::string::npos);
    play("key 4");
    ASSERT_FALSE(measurement().exit.where.empty()) << "two trigonometric moments promise nothing";
    EXPECT_NE(ui::band_note(measurement()).find("no bounds"), std::string::npos);
    play("key 2\nclick @parameter.alpha.auto");
    EXPECT_TRUE(ui::band_note(measurement()).empty()) << "with Table 1's bias nothing leaves it visibly";
    const ui::SeriesRow& bounds = ui::series_rows()[static_cast<std::size_t>(ui::Series::bounds)];
    EXPECT_STREQ(ui::series_name(bounds, require_technique("trig2-32")), "β = 0, β = 1 (no bounds)");
}

// A change of the query depth keeps the curves, and a change that only affects drawing computes nothing.
TEST_F(PlotTest, AChangeRecomputesNoMoreThanItNeeds) {
    open("teapots", "power8-32");
    const auto computed = [&](const std::string& event) {
        const auto memory = measurement().curve.depth.data();
        const std::vector<float> values = measurement().curve.reconstructed;
        play(event);
        // A curve that is computed again has new memory, unless it gets the memory of the curve before the
        // last one.
        return measurement().curve.depth.data() != memory || measurement().curve.reconstructed != values;
    };
    EXPECT_FALSE(computed("drag @plot 0.2 0.2 to @plot 0.8 0.2")) << "the query depth";
    EXPECT_FALSE(computed("key N\nkey B\nkey C\nkey T\nkey Ctrl+3")) << "marks, legend, quantity, tabs";
    EXPECT_FALSE(computed("click @plot.value_axis\nwheel 2")) << "the vertical axis";
    play("key Ctrl+1");
    EXPECT_FALSE(computed("click @parameter.renormalize\nclick @parameter.renormalize.off"))
        << "the composite alone";
    EXPECT_TRUE(computed("drag @parameter.beta 0.25 0.5 to @parameter.beta 0.6 0.5"));
    EXPECT_TRUE(computed("key X")) << "the exact curve";
    EXPECT_TRUE(computed("click " + on_scene({300, 300}))) << "another ray";
}

TEST_F(PlotTest, TheUnbiasedExactCurveIsComputedOnlyWhileItIsShown) {
    open("spheres", "power8-32");
    EXPECT_TRUE(measurement().unbiased_exact.empty());
    play("key X");
    EXPECT_EQ(measurement().unbiased_exact.size(), measurement().curve.depth.size());
}

TEST_F(PlotTest, SharpBoundsAreComputedBesideTheWindowAndHoldTheTruth) {
    open("planes", "trig2-32");
    EXPECT_TRUE(measurement().sharp.depth.empty());
    play("key S");  // the next event waits until background work has ended
    const SharpBounds first = measurement().sharp;
    ASSERT_FALSE(first.depth.empty());
    const std::vector<double> truth = true_absorbance(measurement().capture.ray, first.depth);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_LE(static_cast<double>(first.lower[i]), truth[i] + 1e-5);
        EXPECT_GE(static_cast<double>(first.upper[i]), truth[i] - 1e-5);
    }
    play("drag @parameter.beta 0.25 0.5 to @parameter.beta 0.6 0.5\nclick @legend.stems");
    EXPECT_EQ(measurement().sharp.lower, first.lower) << "they know neither beta nor bias";
    play("drag @parameter.theta 0.25 0.5 to @parameter.theta 0.6 0.5");
    EXPECT_NE(measurement().sharp.lower, first.lower) << "another circle";
    play("key S");
    EXPECT_TRUE(measurement().sharp.depth.empty());
}

TEST_F(PlotTest, DepthsWhereTheTextbookFailsAreTicked) {
    open("planes", "power6-32");
    const char* choose_textbook = "click @parameter.solver\nclick @parameter.solver.textbook\nmove -10 -10";
    play("key Ctrl+5\nclick @editor.preset\nclick @editor.preset.one\nkey Ctrl+1");
    play("hold Ctrl\nclick @parameter.alpha\nlet Ctrl\ntype 0\nkey Enter");
    play(choose_textbook);
    EXPECT_TRUE(measurement().curve.parameters.textbook);
    ASSERT_EQ(measurement().capture.ray.fragments.size(), 1u);
    ASSERT_FALSE(measurement().failure.where.empty()) << "one surface, so the matrix has rank 1";
    EXPECT_NE(ui::failure_note(measurement()), "");
    const auto ticked = screen();
    play("click @parameter.solver\nclick @parameter.solver.robust\nmove -10 -10");
    EXPECT_TRUE(measurement().failure.where.empty());
    EXPECT_EQ(ui::failure_note(measurement()), "");
    EXPECT_GT(changed("plot", ticked, screen()), 20);
    play("hold Ctrl\nclick @parameter.alpha\nlet Ctrl\ntype 0.02\nkey Enter");
    play(choose_textbook);
    EXPECT_TRUE(measurement().failure.where.empty()) << "enough bias";
}

TEST_F(PlotTest, TheCrosshairShowsValues) {
    open("teapots", "power6-32");
    play("move -10 -10");
    const auto before = screen();
    play("move @plot 0.3 0.7");
    EXPECT_GT(changed("plot", before, screen()), 2000);
}

TEST(ParameterHelp, EveryParameterHasATooltipWithAllThatTheRegistryKnows) {
    for (const Parameter& row : parameters()) {
        const std::string help = ui::parameter_help(row);
        for (const char* part : {row.symbol, row.name, row.help, row.key, row.source})
            EXPECT_NE(help.find(part), std::string::npos) << row.key << " lacks " << part;
    }
}

class TooltipTest : public GuiTest {};

TEST_F(TooltipTest, AppearsOverEveryControl) {
    open("planes", "trig3-32");
    for (const Parameter& row : parameters()) {
        const std::string anchor = fmt::format("parameter.{}", row.key);
        const bool of_every_picture =
            std::ranges::find(PICTURE_PARAMETERS, row.id) != PICTURE_PARAMETERS.end();
        ASSERT_EQ(workspace().widget_rects.contains(anchor),
                  state().technique->uses(row.id) || of_every_picture)
            << row.key;
        if (!state().technique->uses(row.id)) continue;
        play("move 5 790");
        const long before = ImGui::GetDrawData()->CmdListsCount;
        play("move @" + anchor);
        EXPECT_GT(ImGui::GetDrawData()->CmdListsCount, before)
            << row.key << ": a tooltip is a window of its own";
    }
}

}  // namespace
}  // namespace momentscope::test
