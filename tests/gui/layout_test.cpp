// layout_test.cpp -- at every size the plot stays legible, and what opens moves nothing.
#include "tests/gui/gui_fixture.hpp"
#include "ui/model/course.hpp"

namespace momentscope::test {
namespace {

constexpr float LEAST_PLOT = 12;  // font heights, less rounding to pixels

struct WindowSize {
    glm::ivec2 pixels;
    float scale;
};

class LayoutTest : public GuiTest, public testing::WithParamInterface<WindowSize> {
protected:
    LayoutTest() : GuiTest(GetParam().pixels) {}

    bool is_large() const { return size_.x > 1280; }

    void open_scaled(const ui::ExplorerState& state) {
        window_.reset();
        window_ = std::make_unique<HeadlessWindow>(shared_gl().context, shared_gl().programs, size_, state,
                                                   ui::WindowOptions{GetParam().scale, false}, log_);
        settle();
    }

    /// In font heights.
    float plot_height() {
        const ui::Rect plot = workspace().widget_rects.at("plot");
        return (plot.high.y - plot.low.y) / ImGui::GetFontSize();
    }

    void expect_inside(const char* anchor) {
        const ui::Rect rect = workspace().widget_rects.at(anchor);
        EXPECT_GE(rect.low.x, 0) << anchor;
        EXPECT_GE(rect.low.y, 0) << anchor;
        EXPECT_LE(rect.high.x, static_cast<float>(size_.x)) << anchor;
        EXPECT_LE(rect.high.y, static_cast<float>(size_.y)) << anchor;
    }
};

TEST_P(LayoutTest, NeverLosesThePlot) {
    for (const ui::ThemeKind theme : {ui::ThemeKind::dark, ui::ThemeKind::light}) {
        for (const ui::Lesson& lesson : ui::own_lessons()) {
            if (is_large() && lesson.id != "causes") continue;  // large pictures take long
            SCOPED_TRACE(lesson.id);
            ui::ExplorerState state;
            state.theme = theme;
            ui::open_lesson(state, lesson);
            open_scaled(state);
            EXPECT_GE(plot_height(), LEAST_PLOT - 0.1f);
            const ui::Rect scene = workspace().widget_rects.at("scene");
            play(lesson.steps[0].answer.empty() ? "click @card.hint" : "click @card.answer");
            EXPECT_TRUE(this->state().answer || this->state().hint);
            EXPECT_GE(plot_height(), LEAST_PLOT - 0.1f);
            const ui::Rect after = workspace().widget_rects.at("scene");
            EXPECT_EQ(scene.low.y, after.low.y) << "the answer moves nothing";
            EXPECT_EQ(scene.high.y, after.high.y);
            for (const char* anchor :
                 {"plot", "plot.depth_axis", "scene", "card", "status", "tab.1", "tab.8"})
                expect_inside(anchor);
            if (is_large()) return;
        }
    }
}

TEST_P(LayoutTest, TheLegendIsThereOrBehindAButton) {
    if (is_large()) GTEST_SKIP() << "it has room for the legend";
    ui::ExplorerState state;
    ui::open_lesson(state, ui::own_lessons()[5]);
    open_scaled(state);
    const bool button = workspace().widget_rects.contains("plot.legend");
    EXPECT_NE(button, workspace().widget_rects.contains("legend.truth"));
    if (button) play("click @plot.legend");
    const bool shown = this->state().plot.shows(ui::Series::truth);
    play("click @legend.truth");
    EXPECT_NE(this->state().plot.shows(ui::Series::truth), shown);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutTest,
                         testing::Values(WindowSize{{1024, 640}, 1}, WindowSize{{1024, 768}, 1.5f},
                                         WindowSize{{1280, 800}, 1}, WindowSize{{1920, 1080}, 1},
                                         WindowSize{{3840, 2160}, 2.5f}),
                         [](const auto& row) {
                             return fmt::format("{}x{}", row.param.pixels.x, row.param.pixels.y);
                         });

}  // namespace
}  // namespace momentscope::test
