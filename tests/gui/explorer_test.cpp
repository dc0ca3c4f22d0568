// explorer_test.cpp -- actions of a user in the window, and the expected results.
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/report/curve_output.hpp"
#include "core/scene/camera.hpp"
#include "tests/effort.hpp"
#include "tests/gui/gui_fixture.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::test {
namespace {

class ExplorerTest : public GuiTest {};

TEST_F(ExplorerTest, OpensOnAPixelWorthSeeing) {
    open("teapots", "power6-32");
    EXPECT_GE(measurement().capture.ray.fragments.size(), 10u);
    EXPECT_TRUE(message().empty());
}

class ParameterTest : public ExplorerTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(ParameterTest, EveryOneMovesItsControlAndChangesWhatIsShown) {
    for (const ParameterId id : require_technique(GetParam()).parameters) {
        const Parameter& row = parameter(id);
        SCOPED_TRACE(row.key);
        if (id == ParameterId::interval) continue;  // alone, it is refused; LessErrorTest chooses it
        // The first value of a choice that is not the default.
        const char* const choice = row.choices.empty() ? "" : row.choices[row.default_value == 0.0f ? 1 : 0];
        open(GetParam() == std::string("trig3-32") ? "planes" : "teapots", GetParam());
        const auto before = screen();
        if (row.scale == Scale::choice)
            play(fmt::format("click @parameter.{0}\nclick @parameter.{0}.{1}\nmove 5 790", row.key, choice));
        else if (row.scale == Scale::toggle)
            play(fmt::format("click @parameter.{}\nmove 5 790", row.key));
        else  // to the minimum for whole numbers, where differences are greatest
            play(fmt::format("drag @parameter.{0} 0.3 0.5 to @parameter.{0} {1} 0.5\nmove 5 790", row.key,
                             row.scale == Scale::whole ? 0.02 : 1));
        const auto after = screen();
        EXPECT_NE(state().parameters[id], ParameterValues()[id]);
        EXPECT_TRUE(message().empty()) << message();
        EXPECT_GT(changed(fmt::format("parameter.{}", row.key), before, after), 0);
        // These change the computation but not the visible picture: less bias than is visible in such a
        // scene, and three ways to the same bits. RobustBias, Textbook, FactorisationTest and Storage
        // distinguish them.
        const bool seen = id != ParameterId::preset && id != ParameterId::solver &&
                          id != ParameterId::factorisation && id != ParameterId::accumulation;
        EXPECT_EQ(changed("scene", before, after) > 50, seen);
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, ParameterTest,
                         ::testing::Values("trig3-32", "wboit", "fourier", "at", "mlab"),
                         [](const auto& one) {
                             return std::string(one.param).substr(0, std::string(one.param).find('-'));
                         });

TEST_F(ExplorerTest, ClickDragAndArrowsPick) {
    open();
    play("click " + on_scene({100, 200}));
    EXPECT_EQ(measurement().pixel, glm::ivec2(100, 200));
    play("drag " + on_scene({100, 200}) + " to " + on_scene({360, 390}));
    EXPECT_EQ(measurement().pixel, glm::ivec2(360, 390));
    EXPECT_FALSE(measurement().capture.ray.fragments.empty());
    play("drag " + on_scene({10, 10}) + " to -50 5000");
    EXPECT_EQ(measurement().pixel.x, 0) << "a drag that leaves the picture stays at its edge";
}

TEST_F(ExplorerTest, TheGoToBoxPicksAndExplainsNonsense) {
    open();
    play("key Ctrl+G\ntype 120, 77\nkey Enter");
    EXPECT_EQ(measurement().pixel, glm::ivec2(120, 77));
    for (const char* nonsense : {"abc", "12", "1 2 3", "-1, 5", "99999, 3", "1e99, 4"}) {
        play(
            fmt::format("key Ctrl+G\ntype {}\nkey Enter\nexpect-message is not a pixel of the picture\nkey "
                        "Escape\nclick @scene.goto\n"
                        "key Ctrl+A\nkey Delete\nkey Escape",
                        nonsense));
        EXPECT_EQ(measurement().pixel, glm::ivec2(120, 77)) << nonsense;
    }
}

TEST_F(ExplorerTest, OrbitPanAndZoomMoveTheCamera) {
    open();
    const Camera own = workspace().camera();
    const auto before = screen();
    play("drag " + on_scene({300, 300}) + " to " + on_scene({400, 330}) + " right");
    EXPECT_LT(workspace().camera().azimuth, own.azimuth);
    EXPECT_GT(workspace().camera().elevation, own.elevation);
    play("drag " + on_scene({300, 300}) + " to " + on_scene({400, 300}) + " middle");
    EXPECT_LT(workspace().camera().target.x, own.target.x)
        << "what is dragged to the right shows what was on the left";
    play("move " + on_scene({300, 300}) + "\nwheel 3");
    EXPECT_LT(workspace().camera().distance, own.distance);
    EXPECT_GT(changed("scene", before, screen()), 1000);
    play("click @scene.reset");
    EXPECT_EQ(workspace().camera(), own);
}

// Panning keeps the point under the mouse there, at the distance of the target.
TEST_F(ExplorerTest, PanningFollowsTheMouse) {
    open();
    const auto on_screen = [&](const glm::vec3& point) {
        const glm::ivec2 size = measurement().picture_size;
        const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
        const glm::vec4 clip = projection_matrix(workspace().camera(), aspect) *
                               view_matrix(workspace().camera()) * glm::vec4(point, 1);
        return 0.5f * glm::vec2(clip) / clip.w * glm::vec2(size);
    };
    const glm::vec3 target = workspace().camera().target;
    play("drag " + on_scene({300, 300}) + " to " + on_scene({360, 330}) + " middle");
    EXPECT_NEAR(on_screen(target).x, 60, 1);
    EXPECT_NEAR(on_screen(target).y, -30, 1);
}

TEST_F(ExplorerTest, ThePlotShowsWhatInspectPrints) {
    open("teapots", "power8-32");
    const Curve& plotted = measurement().curve;
    const ViewRay& ray = measurement().capture.ray;
    const Curve inspected = sample_curve(ray, *plotted.technique, state().parameters, plotted.depth);
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

TEST_F(ExplorerTest, ChangesRunNoMorePassesThanTheyNeed) {
    open("planes", "trig3-32");
    const auto passes_of = [&](const std::string& event) {
        const PassCounts before = window_->renderer().pass_counts();
        play(event);
        const PassCounts& after = window_->renderer().pass_counts();
        return std::array<int, 3>{after.opaque > before.opaque, after.moments > before.moments,
                                  after.color > before.color};
    };
    EXPECT_EQ(passes_of("drag @parameter.beta 0.25 0.5 to @parameter.beta 1 0.5"),
              (std::array<int, 3>{0, 0, 1}));
    EXPECT_EQ(passes_of("drag @parameter.theta 0.2 0.5 to @parameter.theta 0.6 0.5"),
              (std::array<int, 3>{0, 1, 1}));
    EXPECT_EQ(passes_of("click @plot 0.3 0.4\nkey T\nkey P\nkey Ctrl+2\nkey B"),
              (std::array<int, 3>{0, 0, 0}));
    EXPECT_EQ(passes_of("wait 60\nmove 20 780\nmove 60 780"), (std::array<int, 3>{0, 0, 0}));
}

TEST_F(ExplorerTest, IdleDrawsNoFrames) {
    open("teapots", "power6-32");
    const long before = log_.frames();
    play("wait 60");
    EXPECT_EQ(log_.frames(), before);
}

TEST_F(ExplorerTest, AMissingMeshKeepsTheLastGoodScene) {
    open();
    const auto before = screen();
    ui::choose_scene(workspace().state, "/nowhere/at-all.obj");
    settle();
    EXPECT_EQ(state().scene, "planes");
    EXPECT_NE(message().find("at-all.obj"), std::string::npos);
    EXPECT_EQ(changed("scene", before, screen()), 0);
    EXPECT_FALSE(workspace().history.can_undo()) << "what failed is no step";
}

TEST_F(ExplorerTest, AnEmptyPixelSaysSo) {
    open("planes", "trig2-32");
    play("key Ctrl+2");
    EXPECT_FALSE(workspace().widget_rects.contains("plot.empty") ||
                 workspace().widget_rects.contains("fragments.empty"));
    play("click " + on_scene({2, 2}));
    EXPECT_TRUE(workspace().widget_rects.contains("plot.empty") &&
                workspace().widget_rects.contains("fragments.empty"));
    EXPECT_NE(ui::empty_ray_text(measurement()).find("Click on one in the scene"), std::string::npos)
        << "what to do";
    EXPECT_TRUE(measurement().capture.ray.fragments.empty());
    EXPECT_EQ(measurement().curve.total_absorbance, 0);
}

// Some techniques of every family; EveryTechniqueTest draws all of them.
TEST_F(ExplorerTest, TechniquesAndScenesCanBeChosen) {
    open();
    for (std::size_t i = 0; i < techniques().size(); i += static_cast<std::size_t>(effort(4, 1))) {
        const Technique& technique = techniques()[i];
        play(fmt::format("click @controls.technique\nclick @controls.technique.{}", technique.id));
        EXPECT_EQ(state().technique, &technique);
        EXPECT_TRUE(message().empty()) << technique.id << ": " << message();
    }
    for (const char* scene : {"spheres", "teapots", "ties", "cloud", "foliage", "ship", "smoke"}) {
        play(fmt::format("click @controls.scene\nclick @controls.scene.{}", scene));
        EXPECT_EQ(state().scene, scene);
        EXPECT_FALSE(measurement().capture.ray.fragments.empty()) << scene;
    }
}

TEST_F(ExplorerTest, ComparedTechniquesArePlotted) {
    open();
    const auto before = screen();
    play(
        "click @controls.compared\nclick @controls.compared.power4-32\nclick "
        "@controls.compared.trig3-32\nkey Escape\n"
        "click 5 790");
    ASSERT_EQ(measurement().compared.size(), 2u);
    EXPECT_EQ(std::string(measurement().compared[1].technique->id), "trig3-32");
    EXPECT_GT(changed("plot", before, screen()), 200);
    play("click @legend.power4-32");
    EXPECT_EQ(measurement().compared.size(), 1u);
}

TEST_F(ExplorerTest, TheReferenceIsShownWhileHeld) {
    open("spheres", "power4-32");
    const auto before = screen();
    play("hold G");
    EXPECT_TRUE(workspace().comparison.flipped());
    const auto truth = screen();
    EXPECT_GT(changed("scene", before, truth), 1000);
    play("let G");
    EXPECT_FALSE(workspace().comparison.flipped());
    EXPECT_EQ(changed("scene", before, screen()), 0);
    play("move @scene.flip\npress left");
    EXPECT_TRUE(workspace().comparison.flipped());
    play("release left");
    EXPECT_FALSE(workspace().comparison.flipped());
    // The picture equals that of the technique sorted.
    open("spheres", "sorted");
    const ui::Rect rect = workspace().widget_rects.at("scene");
    const auto sorted = screen();
    long differing = 0;
    for (int y = static_cast<int>(rect.low.y) + 60; y < static_cast<int>(rect.high.y);
         ++y)  // below the label
        for (int x = static_cast<int>(rect.low.x); x < static_cast<int>(rect.high.x); ++x)
            differing += std::equal(&sorted[4u * static_cast<unsigned>(y * size_.x + x)],
                                    &sorted[4u * static_cast<unsigned>(y * size_.x + x)] + 4,
                                    &truth[4u * static_cast<unsigned>(y * size_.x + x)])
                             ? 0
                             : 1;
    EXPECT_EQ(differing, 0);
}

TEST_F(ExplorerTest, TheLensShowsThePickedPixelsValue) {
    open("spheres", "power6-32");
    const auto before = screen();
    play("click @scene.lens\nmove 5 790");
    EXPECT_TRUE(state().lens);
    EXPECT_GT(changed("scene", before, screen()), 5000);
    play("click " + on_scene({0, 0}));  // the lens is cut off at the picture's corner
    EXPECT_TRUE(message().empty());
}

TEST_F(ExplorerTest, FailuresAreMarkedWithoutBias) {
    open("spheres", "power8-32");
    play("click @scene.failures\nmove 5 790");
    const auto marked = screen();
    ASSERT_TRUE(workspace().scene_picture.failures);
    EXPECT_EQ(workspace().scene_picture.failures->failed, 0) << "Table 1's bias suffices";
    play("key Ctrl+1\nclick @parameter.alpha 0.01 0.5\nmove 5 790");
    EXPECT_EQ(state().parameters[ParameterId::alpha], std::optional(0.0f));
    ASSERT_TRUE(workspace().scene_picture.failures);
    const long failed = workspace().scene_picture.failures->failed;
    EXPECT_GT(failed, 0);
    EXPECT_GE(changed("scene", marked, screen()), failed) << "each is marked";
}

class TinyWindow : public GuiTest {};

TEST_F(TinyWindow, SurvivesAnySize) {
    open();
    for (const char* size : {"40 1", "1 1", "200 100", "640 400", "1280 800"})
        play(fmt::format("resize {}\nmove 3 0\npress left\nresize 90 70\nmove 60 60\nrelease left", size));
    play("resize 1280 800");
    EXPECT_TRUE(message().empty());
}

// A driver that re-associates makes reconstruction noisy, which more bias hides.
TEST_F(ExplorerTest, BeginsWithMoreBiasWhereRoundingIsLost) {
    Capabilities lost = shared_gl().programs->gl();
    lost.language.rounding = Rounding::lost;
    Renderer renderer(std::make_shared<ProgramCache>(lost));
    const ui::Workspace window(renderer, {}, {});
    EXPECT_EQ(window.state.parameters.get<BiasPreset>(), BiasPreset::robust);
    EXPECT_TRUE(std::ranges::any_of(window.gl.missing, [](const MissingFeature& missing) {
        return missing.feature == "the order of floating-point operations";
    }));
}

}  // namespace
}  // namespace momentscope::test
