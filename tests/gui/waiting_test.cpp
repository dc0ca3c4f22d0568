// waiting_test.cpp -- the window announces a long picture before it draws it.
#include "tests/gui/gui_fixture.hpp"
#include "ui/picture/picture_times.hpp"

#include <algorithm>

namespace momentscope::test {
namespace {

using ui::PictureKind;

TEST(PictureTimesTest, APictureTakesAsLongPerPixelAsTheLastOfItsKind) {
    ui::PictureTimes times;
    const PictureKind kind = {.scene = "planes", .technique = &require_technique("power4-32")};
    EXPECT_EQ(times.expected(kind, {10, 10}), std::nullopt);
    times.took(kind, {10, 10}, 50);
    times.took(kind, {10, 10}, 20);
    EXPECT_DOUBLE_EQ(times.expected(kind, {20, 10}).value(), 40);
    PictureKind other = kind;
    other.stage = Stage::color;
    EXPECT_EQ(times.expected(other, {10, 10}), std::nullopt);
}

class WaitingTest : public GuiTest {
protected:
    WaitingTest() : GuiTest({640, 400}) {}

    // How much of the window the notice covers, from the left.
    float covered() {
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushClipRectFullScreen();
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        explorer().draw_waiting(list);
        const auto [left, right] =
            std::ranges::minmax(list.VtxBuffer, {}, [](const ImDrawVert& v) { return v.pos.x; });
        return (right.pos.x - left.pos.x) / ImGui::GetIO().DisplaySize.x;
    }

    // Counts the calls, and looks at the notice at that moment.
    int announced = 0;
    float last_covered = 0;
    double most_silent_ = 100;
    bool postpones_ = false;
    void open_counting() {
        ui::ExplorerState state;
        state.scene = "planes";
        state.technique = &require_technique("trig2-32");
        ui::WindowOptions options{.show_times = false, .most_silent_milliseconds = most_silent_};
        options.before_long_picture = [this] {
            ++announced;
            last_covered = covered();
            EXPECT_EQ(workspace().report.text(), "") << "it comes before the passes";
            return postpones_;
        };
        window_.reset();
        window_ = std::make_unique<HeadlessWindow>(shared_gl().context, shared_gl().programs, size_, state,
                                                   options, log_);
        settle();
    }
    int announced_by(const std::string& events) {
        const int before = announced;
        play(events);
        return announced - before;
    }
};

TEST_F(WaitingTest, APictureOfAnUnknownKindIsAnnounced) {
    open_counting();
    EXPECT_EQ(announced, 1) << "the first one";
    EXPECT_EQ(last_covered, 1) << "there is no picture yet to write over";
    EXPECT_EQ(announced_by("click @controls.technique\nclick @controls.technique.trig3-32"), 1);
    EXPECT_LT(last_covered, 0.5f) << "the last picture stays to be seen";
    EXPECT_EQ(announced_by("key O"), 1) << "failures are marked";
    EXPECT_EQ(announced_by("key W"), 1) << "a reference is drawn";
    EXPECT_EQ(announced_by("click @card.order"), 1) << "another scene";
}

// As in a browser, where the notice is seen only after the frame.
TEST_F(WaitingTest, APictureMayWaitForTheNextFrame) {
    postpones_ = true;
    open_counting();
    EXPECT_EQ(announced, 1) << "the first one";
    EXPECT_EQ(announced_by("click @controls.technique\nclick @controls.technique.trig3-32"), 1);
    EXPECT_EQ(announced_by("click @card.order\nkey W"), 2) << "another scene, then a reference";
    EXPECT_FALSE(workspace().picture_waits);
    EXPECT_EQ(workspace().shown, workspace().state);
}

TEST_F(WaitingTest, WhatDrawsNoPictureIsNotAnnounced) {
    open_counting();
    EXPECT_EQ(announced_by("click @scene 0.3 0.3\nclick @tab.2\nkey L\nmove @plot\nwait 1"), 0);
}

TEST_F(WaitingTest, AKnownPictureIsAnnouncedOnlyWhenItTakesLong) {
    for (const double most : {0.0, std::numeric_limits<double>::infinity()}) {
        most_silent_ = most;
        open_counting();
        play("move @scene\nwheel 1\nwheel 1");
        EXPECT_EQ(announced_by("wheel -1\nwheel -1"), most == 0 ? 2 : 0);
    }
}

}  // namespace
}  // namespace momentscope::test
