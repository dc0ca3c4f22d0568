// explorer_test.cpp -- what a user does in the window, and what must follow.
#include <fmt/format.h>

#include "core/inspect/curve_output.hpp"
#include "tests/gui/gui_fixture.hpp"
#include "ui/plot.hpp"

#include <nlohmann/json.hpp>

namespace momentscope::test {
namespace {

class ExplorerTest : public GuiTest {
protected:
    /// How many pixels of the scene's half and of the plot's half differ between two screens.
    struct Changed {
        long scene = 0, right = 0;
    };
    Changed changed(const std::vector<unsigned char>& before, const std::vector<unsigned char>& after) const {
        Changed count;
        const int border = static_cast<int>(explorer_->scene_corner().x) + explorer_->result().picture_size.x;
        for (int y = 0; y < explorer_->result().picture_size.y; ++y)  // not the status line below
            for (int x = 0; x < size_.x; ++x) {
                const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                                            static_cast<std::size_t>(x));
                const bool same = std::equal(&before[at], &before[at] + 4, &after[at]);
                (x < border ? count.scene : count.right) += same ? 0 : 1;
            }
        return count;
    }
};

TEST_F(ExplorerTest, OpensOnAPixelWorthSeeing) {
    const ui::Explorer& explorer = open("teapots", "power6-32");
    EXPECT_GE(explorer.result().capture.ray.fragments.size(), 10u);
    EXPECT_TRUE(explorer.message().empty());
}

TEST_F(ExplorerTest, DraggingASliderChangesPlotAndPicture) {
    ui::Explorer& explorer = open("planes", "trig3-32");
    for (const ParameterId id : explorer.state().technique->parameters) {
        const auto before = screen();
        const Parameter& row = parameter(id);
        // Set through the state, as a slider does; where sliders are is the layout's business.
        explorer.state().parameters.set(id, row.scale == Scale::toggle ? row.minimum : row.maximum);
        draw();
        const Changed difference = changed(before, screen());
        EXPECT_GT(difference.right, 0) << row.key << " moves its control";
        if (id == ParameterId::alpha) continue;  // at its greatest it may leave these few sheets as they are
        EXPECT_GT(difference.scene, 50) << row.key << " changes the picture";
    }
}

TEST_F(ExplorerTest, TheBetaSliderFollowsTheMouse) {
    ui::Explorer& explorer = open("planes", "power4-32");
    const float before = *explorer.state().parameters[ParameterId::beta];
    const auto first = screen();
    // The slider is found by its effect: drag along rows below the plot until beta moves.
    bool moved = false;
    for (float y = 460; y < 700 && !moved; y += 8) {
        drag({1050, y}, {1230, y}, 0);
        moved = *explorer.state().parameters[ParameterId::beta] != before;
        if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) click({5, 5});  // a combo opened instead
    }
    EXPECT_TRUE(moved);
    EXPECT_GT(*explorer.state().parameters[ParameterId::beta], before);
    EXPECT_GT(changed(first, screen()).scene, 50);
}

TEST_F(ExplorerTest, ClickAndDragPick) {
    ui::Explorer& explorer = open("planes", "power6-32");
    click(on_scene({100, 200}));
    EXPECT_EQ(explorer.result().pixel, glm::ivec2(100, 200));
    drag(on_scene({100, 200}), on_scene({360, 390}), 0);
    EXPECT_EQ(explorer.result().pixel, glm::ivec2(360, 390));
    EXPECT_FALSE(explorer.result().capture.ray.fragments.empty());
    tap(ImGuiKey_LeftArrow);
    tap(ImGuiKey_UpArrow);
    EXPECT_EQ(explorer.result().pixel, glm::ivec2(359, 389));
    drag(on_scene({10, 10}), {-50, 5000}, 0);
    EXPECT_EQ(explorer.result().pixel.x, 0) << "a drag that leaves the picture stays at its edge";
}

TEST_F(ExplorerTest, OrbitAndZoomMoveTheCamera) {
    ui::Explorer& explorer = open("planes", "power6-32");
    const auto before = screen();
    drag(on_scene({300, 300}), on_scene({400, 330}), 1);
    ASSERT_TRUE(explorer.state().camera);
    const float azimuth = explorer.state().camera->azimuth;
    EXPECT_NE(azimuth, 0);
    wheel(on_scene({300, 300}), 3);
    EXPECT_LT(explorer.state().camera->distance, 6);
    EXPECT_GT(changed(before, screen()).scene, 1000);
}

TEST_F(ExplorerTest, ThePlotShowsWhatInspectPrints) {
    const ui::Explorer& explorer = open("teapots", "power8-32");
    const Curve& plotted = explorer.result().curve;
    const ViewRay& ray = explorer.result().capture.ray;
    const Curve inspected = sample_curve(ray, *plotted.technique, explorer.state().parameters, plotted.depth);
    const auto json = nlohmann::json::parse(curves_to_json(ray, {inspected}));
    const auto& curve = json["curves"][0];
    ASSERT_EQ(curve["depth"].size(), plotted.depth.size());
    for (std::size_t i = 0; i < plotted.depth.size(); ++i) {
        ASSERT_EQ(curve["reconstructed"][i].get<float>(), plotted.reconstructed[i]);
        ASSERT_EQ(curve["lower"][i].get<float>(), plotted.beta0[i]);
        ASSERT_EQ(curve["upper"][i].get<float>(), plotted.beta1[i]);
        ASSERT_EQ(curve["true"][i].get<double>(), plotted.truth[i]);
    }
}

TEST_F(ExplorerTest, NothingChangedDrawsNothing) {
    open("planes", "power6-32");
    const PassCounts before = renderer_.pass_counts();
    draw(5);
    EXPECT_EQ(renderer_.pass_counts().composite, before.composite);
}

TEST_F(ExplorerTest, AMissingSceneKeepsTheLastGoodOne) {
    ui::Explorer& explorer = open("planes", "power6-32");
    const auto before = screen();
    explorer.state().scene = "/nowhere/at-all.obj";
    draw(2);
    EXPECT_EQ(explorer.state().scene, "planes");
    EXPECT_NE(explorer.message().find("at-all.obj"), std::string::npos);
    EXPECT_EQ(changed(before, screen()).scene, 0);
}

TEST_F(ExplorerTest, AnEmptyPixelSaysSo) {
    const ui::Explorer& explorer = open("planes", "trig2-32");
    click(on_scene({2, 2}));
    EXPECT_TRUE(explorer.result().capture.ray.fragments.empty());
    EXPECT_EQ(explorer.result().curve.total_absorbance, 0);
}

TEST_F(ExplorerTest, EveryTechniqueAndSceneCanBeShown) {
    ui::Explorer& explorer = open("planes", "power4-32");
    for (const Technique& technique : techniques()) {
        explorer.state().technique = &technique;
        draw(2);
        EXPECT_TRUE(explorer.message().empty()) << technique.id << ": " << explorer.message();
    }
    for (const char* scene : {"spheres", "teapots"}) {
        explorer.state().scene = scene;
        draw(2);
        EXPECT_TRUE(explorer.message().empty()) << scene;
        EXPECT_FALSE(explorer.result().capture.ray.fragments.empty()) << scene;
    }
}

class TinyWindow : public GuiTest {
protected:
    TinyWindow() : GuiTest({40, 1}) {}
};

TEST_F(TinyWindow, DoesNotCrash) {
    open("planes", "power6-32");
    draw(2);
}

}  // namespace
}  // namespace momentscope::test
