// draft_test.cpp -- while the mouse drags, the picture is drawn at a reduced resolution; at rest it is the
// full picture again.
#include "core/scene/camera.hpp"
#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {
namespace {

class DraftTest : public GuiTest {
protected:
    DraftTest() : GuiTest({960, 600}) { most_milliseconds_ = 0; }

    static void point(ImVec2 at, int button, bool down) {
        ImGui::GetIO().MousePos = at;
        ImGui::GetIO().MouseDown[button] = down;
    }

    ImVec2 on(const std::string& anchor, float x, float y) {
        const ui::Rect rect = workspace().widget_rects.at(anchor);
        return {rect.low.x + x * (rect.high.x - rect.low.x), rect.low.y + y * (rect.high.y - rect.low.y)};
    }

    /// Drags in steps and keeps the button down at the end. Returns the number of frames with drafts.
    int drag(ImVec2 from, ImVec2 to, int button) {
        point(from, button, false);
        draw();
        point(from, button, true);
        draw();
        int drafts = 0;
        for (int i = 1; i <= 10; ++i) {
            const float share = 0.1f * static_cast<float>(i);
            point({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}, button, true);
            draw();
            drafts += workspace().report.draft ? 1 : 0;
            EXPECT_FALSE(workspace().report.opaque) << "the full picture waits";
        }
        return drafts;
    }
};

TEST_F(DraftTest, OfASliderBecomesTheFullPictureAtRest) {
    open("planes", "power6-32");
    const std::vector<unsigned char> before = screen();
    EXPECT_GE(drag(on("parameter.beta", 0.3f, 0.5f), on("parameter.beta", 0.9f, 0.5f), 0), 5);
    EXPECT_TRUE(workspace().picture.shows_draft());
    draw();  // controls are drawn after the picture and affect the next one
    EXPECT_TRUE(workspace().picture.shows_draft());
    EXPECT_FLOAT_EQ(measurement().curve.parameters.beta, *state().parameters[ParameterId::beta])
        << "the plot is of now";
    point(on("parameter.beta", 0.9f, 0.5f), 0, false);
    settle();
    EXPECT_FALSE(workspace().picture.shows_draft());
    point({-10, -10}, 0, false);
    settle();
    const std::vector<unsigned char> after = screen();
    EXPECT_GT(changed("scene", before, after), 0);
    const ui::ExplorerState same = state();
    open(same);
    EXPECT_EQ(changed("scene", after, screen()), 0) << "as if it had never been drafted";
}

TEST_F(DraftTest, OfTheCameraKeepsTheRayExact) {
    open("planes", "power6-32");
    EXPECT_GE(drag(on("scene", 0.5f, 0.5f), on("scene", 0.6f, 0.5f), 1), 5);
    EXPECT_TRUE(workspace().picture.shows_draft());
    EXPECT_EQ(measurement().capture.ray.fragments.size(), 4u)
        << "fragments are of the place as it is seen now";
    point(on("scene", 0.6f, 0.5f), 1, false);
    settle();
    EXPECT_FALSE(workspace().picture.shows_draft());
    const ViewRay at_rest = measurement().capture.ray;
    const ui::ExplorerState same = state();
    open(same);
    EXPECT_EQ(measurement().capture.ray, at_rest);
}

TEST_F(DraftTest, HeldStillBecomesTheFullPictureToo) {
    open("planes", "power6-32");
    const ImVec2 end = on("parameter.beta", 0.8f, 0.5f);
    drag(on("parameter.beta", 0.3f, 0.5f), end, 0);
    for (int i = 0; i < 20 && workspace().picture.shows_draft(); ++i) draw();
    EXPECT_FALSE(workspace().picture.shows_draft()) << "after a fifth of a second";
    point(end, 0, false);
    settle();
}

TEST_F(DraftTest, IsNotMadeOfWhatIsFastEnough) {
    most_milliseconds_ = 1e9;
    open("planes", "power6-32");
    point(on("parameter.beta", 0.3f, 0.5f), 0, true);
    draw();
    point(on("parameter.beta", 0.9f, 0.5f), 0, true);
    draw();
    EXPECT_FALSE(workspace().picture.shows_draft());
    point({-10, -10}, 0, false);
    settle();
}

}  // namespace
}  // namespace momentscope::test
