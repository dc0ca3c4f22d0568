// light_test.cpp -- the plot of the light's ray.
#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {
namespace {

class LightTest : public GuiTest {
protected:
    LightTest() : GuiTest({1280, 1000}) {}

    /// A pixel of the ground in the middle of the disk's shadow.
    std::string shadowed() {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        return fmt::format("{} {}", rect.low.x + 0.557f * (rect.high.x - rect.low.x),
                           rect.low.y + 0.636f * (rect.high.y - rect.low.y));
    }
};

TEST_F(LightTest, PickingAShadowedPixelAndDraggingBetaChangesPictureAndCurve) {
    open("cloud", "power6-32");
    play("click @plot.light\nclick " + shadowed() + "\nmove -10 -10");
    ASSERT_TRUE(measurement().light.has_value());
    EXPECT_EQ(state().parameters[ParameterId::shadows], 1.0f) << "the light's plot needs shadows";
    EXPECT_STREQ(measurement().curve.technique->id, "power6-32");
    EXPECT_EQ(measurement().curve.parameters.beta, 0.0f) << "the light has a beta of its own";
    EXPECT_EQ(measurement().curve.truth.size(), measurement().curve.depth.size());
    EXPECT_LT(measurement().light->visibility, 0.5) << "it lies in the disk's shadow";
    EXPECT_NEAR(measurement().light->visibility,
                (1 - measurement().light->breakdown.shadowed) * measurement().light->breakdown.transmittance,
                1e-3);
    EXPECT_EQ(measurement().canonical.query, measurement().light->bundle.place.depth);
    const std::vector<float> curve = measurement().curve.reconstructed;
    const std::vector<unsigned char> before = screen();
    play("drag @parameter.shadow-beta 0.02 0.5 to @parameter.shadow-beta 0.7 0.5\nmove -10 -10");
    EXPECT_GT(*state().parameters[ParameterId::shadow_beta], 0.4f);
    EXPECT_NE(measurement().curve.reconstructed, curve);
    const std::vector<unsigned char> after = screen();
    EXPECT_GT(changed("scene", before, after), 1000) << "shadows in the picture";
    EXPECT_GT(changed("plot", before, after), 200);
    play("key Ctrl+Z");
    EXPECT_EQ(state().parameters[ParameterId::shadow_beta], 0.0f) << "one step of undo";
    EXPECT_EQ(measurement().curve.reconstructed, curve);
}

TEST_F(LightTest, BetaOfTheEyeLeavesTheLightsCurve) {
    open("cloud", "power6-32");
    play("click @plot.light\nclick " + shadowed());
    const std::vector<float> curve = measurement().curve.reconstructed;
    workspace().state.parameters.set(ParameterId::beta, 0.9f);
    settle();
    EXPECT_EQ(measurement().curve.reconstructed, curve);
    workspace().state.parameters.set(ParameterId::shadow_technique, 0.0f);
    settle();
    EXPECT_STREQ(measurement().curve.technique->id, "power4-32");
}

TEST_F(LightTest, TheMarkedFragmentReceives) {
    open("cloud", "power6-32");
    const std::size_t fragments = measurement().capture.ray.fragments.size();
    ASSERT_GT(fragments, 5U);
    workspace().state.marked = 3;
    settle();
    play("key V");
    ASSERT_TRUE(measurement().light.has_value());
    EXPECT_EQ(measurement().light->fragment, 3U);
    EXPECT_FALSE(state().marked.has_value()) << "fragments of another ray are shown now";
    play("key V");
    EXPECT_FALSE(measurement().light.has_value());
    EXPECT_EQ(state().marked, 3U);
    EXPECT_EQ(measurement().capture.ray.fragments.size(), fragments);
}

TEST_F(LightTest, WhatCoversThePixelByHalfReceives) {
    open("cloud", "power6-32");
    const ViewRay eye = measurement().capture.ray;
    play("key V");
    const std::optional<std::size_t> receiver = measurement().light->fragment;
    ASSERT_TRUE(receiver.has_value());
    double before = 1;
    for (const Fragment& fragment : eye.fragments)
        if (fragment.depth < eye.fragments[*receiver].depth)
            before *= 1 - static_cast<double>(fragment.opacity);
    EXPECT_GT(before, 0.5);
    EXPECT_LE(before * (1 - static_cast<double>(eye.fragments[*receiver].opacity)), 0.5);
}

TEST_F(LightTest, AnotherPixelHasAnotherReceiver) {
    open("cloud", "power6-32");
    workspace().state.marked = 3;
    settle();
    play("key V\nclick " + shadowed());
    EXPECT_FALSE(state().receiver.has_value());
    EXPECT_FALSE(measurement().light->fragment.has_value()) << "the ground";
}

TEST_F(LightTest, ShadowsTurnedOffShowTheEyesRay) {
    open("cloud", "power6-32");
    workspace().state.marked = 3;
    settle();
    play("key V");
    workspace().state.marked = 200;
    workspace().state.parameters.turn(ParameterId::shadows, false);
    settle();
    EXPECT_EQ(state().viewpoint, ui::Viewpoint::eye);
    EXPECT_EQ(state().marked, 3U) << "as before";
    EXPECT_FALSE(measurement().light.has_value());
}

TEST_F(LightTest, TheTextbookIsTheEyesAlone) {
    ui::ExplorerState wanted;
    wanted.scene = "cloud";
    wanted.parameters.set(Solver::textbook);
    open(wanted);
    play("key V");
    EXPECT_FALSE(measurement().curve.parameters.textbook) << "maps are looked up by the robust solver";
}

TEST_F(LightTest, OpaqueCastersSumToOne) {
    open("teapots", "power4-32");
    play("click @plot.opaque");
    ASSERT_TRUE(measurement().light.has_value());
    EXPECT_NEAR(measurement().curve.total_absorbance, 1, 1e-4);
    EXPECT_STREQ(measurement().curve.technique->id, "power4-32");
    EXPECT_EQ(measurement().curve.parameters.alpha, 6e-5f) << "of hamburger-16, the standard";
    play("click @plot.eye");
    EXPECT_FALSE(measurement().light.has_value());
}

TEST_F(LightTest, TheSkyReceivesNothing) {
    open("cloud", "power6-32");
    const ui::Rect rect = workspace().widget_rects.at("scene");
    play(fmt::format("key V\nclick {} {}\nexpect-message receive", rect.low.x + 5, rect.low.y + 5));
    EXPECT_EQ(state().viewpoint, ui::Viewpoint::eye);
    EXPECT_FALSE(measurement().light.has_value());
}

TEST_F(LightTest, ALightAmongTheCastersIsRefusedAndTheLastPictureStays) {
    open("cloud", "power6-32");
    play("key V");
    const std::vector<unsigned char> before = screen();
    workspace().state.parameters.set(ParameterId::light_distance, 1.0f);
    settle();
    EXPECT_NE(message().find("--light-distance"), std::string::npos) << message();
    EXPECT_FALSE(state().parameters[ParameterId::light_distance].has_value());
    EXPECT_EQ(changed("scene", before, screen()), 0);
}

}  // namespace
}  // namespace momentscope::test
