// advise_test.cpp -- advice for a real scene: the advised technique keeps its bound at views that were never
// measured.
#include <gtest/gtest.h>

#include "core/bench/held_out.hpp"
#include "core/bench/measure.hpp"
#include "core/chart/advice.hpp"
#include "core/chart/grid.hpp"
#include "core/report/advice_text.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 ADVICE_SIZE(96, 54);

class AdviseTest : public GlTest<> {
protected:
    void measure(const std::vector<const char*>& configurations) {
        scene_ = load_scene("spheres", 0.4f);
        for (const char* text : configurations) configurations_.push_back(parse_configuration(text));
        ChartSettings settings;
        settings.size = ADVICE_SIZE;
        settings.repeat = 1;
        ChartBench bench(scene_, settings);
        rows_ = bench.measure(configurations_, {}, [] {});
        held_out_.assign(rows_.size(), std::nullopt);
    }

    Advice advice_for(double max_error) {
        AdviceBounds bounds;
        bounds.max_error = max_error;
        HeldOutViews views(scene_, ADVICE_SIZE, {});
        return *checked_advice(rows_, bounds, held_out_, [&](std::size_t row) {
            double worst = 0;
            for (std::size_t view = 0; view < views.count(); ++view)
                worst = std::max(worst, views.error(configurations_[row], view, Metric::rmse));
            return std::optional(worst);
        });
    }

    Image drawn(const Camera& camera, const Configuration& configuration) const {
        Renderer renderer(shared_programs());
        renderer.set_scene(scene_);
        renderer.render({camera, ADVICE_SIZE, configuration.technique, configuration.values});
        return renderer.read_picture();
    }

    Scene scene_;
    std::vector<Configuration> configurations_;
    std::vector<ChartRow> rows_;
    HeldOutErrors held_out_;
};

TEST_F(AdviseTest, ATightBoundHoldsAtAViewOfItsOwn) {
    measure(
        {"unsorted", "wboit", "power4-32", "power8-32", "trig4-32", "at", "at:nodes=8", "mlab", "sorted"});
    constexpr double BOUND = 0.01;
    const Advice advice = advice_for(BOUND);
    ASSERT_TRUE(advice.winner);
    const Configuration& winner = configurations_[*advice.winner];
    EXPECT_FALSE(winner.technique->is_truth());
    EXPECT_GT(rows_[1].numbers->rmse, BOUND) << "the bound is tight";
    Camera camera = scene_.camera;  // neither the scene's view nor a held-out one
    camera.azimuth += 0.2f;
    camera.elevation += 0.08f;
    const Image reference = drawn(camera, {&require_technique("sorted"), {}});
    EXPECT_LE(mean_difference(reference, drawn(camera, winner), Metric::rmse), BOUND)
        << configuration_text(winner);
    EXPECT_GT(mean_difference(reference, drawn(camera, configurations_[1]), Metric::rmse), BOUND);
}

TEST_F(AdviseTest, WhatFailsAtHeldOutViewsIsNotAdvised) {
    measure({"power4-32", "power6-32", "power8-32", "trig2-32"});
    // With this bound, the fastest configurations meet it at their own view, but nowhere else.
    for (std::size_t i = 0; i < 2; ++i) rows_[i].numbers->rmse = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].numbers->total = {static_cast<double>(i + 1), 0};
    rows_[2].numbers->rmse = 0;
    HeldOutViews views(scene_, ADVICE_SIZE, {});
    std::vector<double> worst(rows_.size(), 0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (std::size_t view = 0; view < views.count(); ++view)
            worst[i] = std::max(worst[i], views.error(configurations_[i], view, Metric::rmse));
    ASSERT_LT(worst[2], worst[0]) << "eight moments are better than four";
    const double bound = worst[2];
    const Advice advice = advice_for(bound);
    ASSERT_TRUE(advice.winner);
    EXPECT_LE(worst[*advice.winner], bound);
    EXPECT_NE(*advice.winner, 0U);
    EXPECT_EQ(held_out_[0], worst[0]) << "it was tried, and repeats";
}

TEST_F(AdviseTest, AnImpossibleBoundIsRefused) {
    measure({"wboit", "power4-32", "power8-32", "sorted"});
    AdviceBounds bounds;
    bounds.max_error = 1e-9;
    const Advice advice = advice_for(bounds.max_error);
    EXPECT_EQ(advice.winner, std::nullopt);
    EXPECT_EQ(advice.nearest, std::optional<std::size_t>(2));
    EXPECT_EQ(advice.ground_truths, std::vector<std::size_t>{3});
    EXPECT_NE(no_advice_text(rows_, bounds, held_out_, advice).find("Only a ground truth"),
              std::string::npos);
}

TEST(HeldOut, ViewsDifferFromTheMeasuredOne) {
    Camera camera;
    camera.elevation = 1.45f;
    for (const Camera& other : held_out_cameras(camera)) {
        EXPECT_NE(other, camera);
        EXPECT_LT(std::abs(other.elevation), 1.5f);
        EXPECT_EQ(other.distance, camera.distance);
    }
}

}  // namespace
}  // namespace momentscope::test
