// selection_test.cpp -- pins, marks and the table of fragments in the window.
#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {
namespace {

class SelectionTest : public GuiTest {};

TEST_F(SelectionTest, PinsKeepSmallPlots) {
    open();
    play("key P\nclick " + on_scene({250, 330}) + "\nkey P");
    ASSERT_EQ(measurement().pins.size(), 2u);
    EXPECT_EQ(measurement().pins[1].pixel, glm::ivec2(250, 330));
    EXPECT_EQ(measurement().pins[1].ray, measurement().capture.ray);
    play("click @pin.1");
    EXPECT_EQ(measurement().pixel, measurement().pins[0].pixel);
    play("click @pin.1.remove");
    EXPECT_EQ(measurement().pins.size(), 1u);
    for (const char* place : {"0.1", "0.2", "0.3", "0.4"})
        play(fmt::format("click @scene {} 0.5\nkey P", place));
    EXPECT_EQ(measurement().pins.size(), ui::MAX_PINS);
    EXPECT_NE(message().find("Four pixels"), std::string::npos);
    play("drag " + on_scene({300, 300}) + " to " + on_scene({320, 300}) + " right");
    EXPECT_EQ(measurement().pins.size(), ui::MAX_PINS) << "another camera, the same places";
}

TEST_F(SelectionTest, ARowAndAStepMarkTheSameFragment) {
    open("planes", "power4-32");
    play("key Ctrl+2\nclick @fragment.3");
    ASSERT_TRUE(state().marked);
    EXPECT_EQ(*state().marked, measurement().history[2].fragment);
    const float depth = measurement().capture.ray.fragments[*state().marked].depth;
    EXPECT_EQ(measurement().canonical.query, depth) << "the query depth goes there";
    play("click @fragment.3");
    EXPECT_FALSE(state().marked);
    // In the plot, click on the step of the second fragment.
    const float second = measurement().capture.ray.fragments[measurement().history[1].fragment].depth;
    play(fmt::format("click @plot {} 0.5", 0.5f * (second + 1)));
    ASSERT_TRUE(state().marked);
    EXPECT_EQ(*state().marked, measurement().history[1].fragment);
}

TEST_F(SelectionTest, TheTableHasTheGlsTransmittance) {
    open("teapots", "power6-32");
    play("key Ctrl+2");
    ASSERT_FALSE(measurement().history.empty());
    for (const PixelHistoryRow& row : measurement().history) {
        ASSERT_TRUE(row.gl_transmittance);
        EXPECT_EQ(*row.gl_transmittance, row.transmittance) << "GL and C++ from the same source";
    }
    const auto expect_same = [&](const char* why) {
        for (const PixelHistoryRow& row : measurement().history)
            EXPECT_EQ(row.gl_transmittance, row.transmittance) << "captured again after a change of " << why;
    };
    const auto before = measurement().history.front().transmittance;
    play("key Ctrl+1\ndrag @parameter.beta 0.25 0.5 to @parameter.beta 0.9 0.5\nkey Ctrl+2");
    EXPECT_NE(measurement().history.front().transmittance, before);
    expect_same("beta, which leaves the fragments as they are");
    play("key 1");
    expect_same("technique");
}

}  // namespace
}  // namespace momentscope::test
