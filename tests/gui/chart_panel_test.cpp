// chart_panel_test.cpp -- the tab that measures techniques between frames, and the use of its rows.
#include "core/chart/chart.hpp"
#include "core/chart/grid.hpp"
#include "tests/gui/folder_fixture.hpp"

namespace momentscope::test {
namespace {

class ChartPanelTest : public FolderTest {
protected:
    /// Gives the tab so much space that nothing needs scrolling.
    void open_planes() {
        ui::ExplorerState state;
        state.scene = "planes";
        state.plot_share = 0.2f;
        open(state);
    }
    const ui::TechniqueChart& panel() { return workspace().chart; }
    const std::vector<ChartRow>& rows() { return panel().measurement().rows(); }
    bool shows(const std::string& anchor) { return workspace().widget_rects.contains(anchor); }

    /// Measures every technique once, at a small size.
    void measure() {
        play(
            "key Ctrl+8\nclick @chart.size\nclick @chart.size.160\nclick @chart.standards_only\nclick @chart.measure");
        ASSERT_FALSE(panel().busy());
        ASSERT_EQ(rows().size(), techniques().size());
    }

    std::size_t row_of(const std::string& configuration) {
        const auto found = std::ranges::find(rows(), configuration, &ChartRow::configuration);
        return static_cast<std::size_t>(found - rows().begin());
    }
};

TEST_F(ChartPanelTest, MeasuresEveryTechniqueAndAClickChoosesOne) {
    open_planes();
    play("key Ctrl+8");
    EXPECT_EQ(state().panel, ui::Panel::chart);
    EXPECT_TRUE(shows("chart.measure"));
    EXPECT_FALSE(shows("chart.plot")) << "nothing was measured";
    measure();
    for (std::size_t i = 0; i < rows().size(); ++i) {
        EXPECT_EQ(rows()[i].configuration, techniques()[i].id);
        EXPECT_TRUE(rows()[i].numbers || !rows()[i].unavailable.empty());
    }
    EXPECT_EQ(rows()[row_of("sorted")].numbers->rmse, 0);
    ASSERT_TRUE(shows("chart.wboit"));
    play("move @chart.plot 0.5 0.01\nclick @chart.wboit");
    EXPECT_EQ(std::string(state().technique->id), "wboit");
    play("key Ctrl+Z");
    EXPECT_EQ(std::string(state().technique->id), "power6-32") << "one step";
}

TEST_F(ChartPanelTest, AdviceFollowsTheBoundsAndIsChecked) {
    open_planes();
    measure();
    ASSERT_TRUE(panel().advice() && panel().advice()->winner);
    const std::size_t winner = *panel().advice()->winner;
    const auto held_out = panel().measurement().held_out(Metric::rmse);
    ASSERT_TRUE(held_out[winner]);
    EXPECT_LE(*held_out[winner], 0.01);
    EXPECT_LE(rows()[winner].numbers->rmse, 0.01);
    play("click @chart.use.cheapest");
    EXPECT_EQ(rows()[winner].configuration, state().technique->id);
    play("drag @chart.max_error to -2000 400");  // to its minimum: only the truth meets it
    ASSERT_TRUE(panel().advice());
    for (const auto& row : {panel().advice()->winner, panel().advice()->nearest})
        EXPECT_TRUE(!row || panel().measurement().held_out(Metric::rmse)[*row]) << "checked";
    play("click @chart.bounds_bits\ndrag @chart.max_bits to -2000 400");  // one bit is too few
    EXPECT_FALSE(panel().advice()->winner);
    ASSERT_TRUE(panel().advice()->nearest);
    EXPECT_TRUE(shows("chart.nothing"));
    const std::string nearest = rows()[*panel().advice()->nearest].configuration;
    play("click @chart.use.nearest");
    EXPECT_EQ(nearest, state().technique->id);
}

TEST_F(ChartPanelTest, RowsOfAnotherSceneAreStale) {
    open_planes();
    measure();
    EXPECT_FALSE(shows("chart.stale"));
    workspace().state.scene = "spheres";
    settle();
    EXPECT_TRUE(shows("chart.stale"));
    play("click @chart.wboit");
    EXPECT_EQ(std::string(state().technique->id), "power6-32") << "a click does nothing";
    workspace().state.scene = "planes";
    settle();
    EXPECT_FALSE(shows("chart.stale"));
}

TEST_F(ChartPanelTest, MeasuresBetweenFramesAndCanBeEnded) {
    open_planes();
    play("key Ctrl+8\nclick @chart.size\nclick @chart.size.160");
    ui::measure_chart(workspace());
    const std::size_t all = panel().measurement().steps();
    EXPECT_EQ(all, chart_steps(chart_grid().size(), panel().measurement().settings()));
    std::size_t before = 0;
    while (rows().empty()) {
        draw();
        EXPECT_GT(panel().measurement().steps_done(), before) << "a little in every frame";
        before = panel().measurement().steps_done();
        EXPECT_TRUE(ui::wants_frame(workspace()));
    }
    EXPECT_LT(before, all);
    EXPECT_TRUE(shows("chart.cancel"));
    const ui::Rect rect = workspace().widget_rects.at("chart.cancel");
    ImGui::GetIO().MousePos = {0.5f * (rect.low.x + rect.high.x), 0.5f * (rect.low.y + rect.high.y)};
    draw();
    ImGui::GetIO().MouseDown[0] = true;
    draw();
    ImGui::GetIO().MouseDown[0] = false;
    draw();
    EXPECT_FALSE(panel().measuring());
    const std::size_t kept = rows().size();
    EXPECT_GT(kept, 0U);
    settle();
    EXPECT_EQ(rows().size(), kept) << "finished rows stay";
    ui::measure_chart(workspace());
    draw();
    workspace().state.scene = "spheres";
    settle();
    EXPECT_FALSE(panel().measuring()) << "another scene ends it";
    EXPECT_NE(message().find("chart was stopped"), std::string::npos) << message();
}

TEST_F(ChartPanelTest, FilesAreThoseOfTheCommandLine) {
    open_planes();
    measure();
    panel().write(folder_ / "chart.csv", workspace().gl);
    const Chart chart = chart_of(read_run_table(folder_ / "chart.csv"), "the test");
    ASSERT_EQ(chart.rows.size(), rows().size());
    EXPECT_EQ(setting(chart.settings, "size"), "160x90");
    for (std::size_t i = 0; i < rows().size(); ++i)
        EXPECT_EQ(chart.rows[i].configuration, rows()[i].configuration);
    for (const char* name : {"chart.html", "chart.svg", "chart.md"}) {
        panel().write(folder_ / name, workspace().gl);
        EXPECT_GT(std::filesystem::file_size(folder_ / name), 1000U) << name;
    }
}

}  // namespace
}  // namespace momentscope::test
