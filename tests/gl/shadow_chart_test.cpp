// shadow_chart_test.cpp -- chart --shadows: its rows and its text.
#include "core/bench/shadow_chart.hpp"

#include <algorithm>

#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

class ShadowChartTest : public GlTest<testing::Test> {
protected:
    static ShadowChartSettings small() {
        ShadowChartSettings settings;
        settings.techniques = {"fourier-7", "power6-32"};
        settings.map_sizes = {32, 64};
        settings.size = {64, 36};
        settings.repeat = 2;
        return settings;
    }
};

TEST_F(ShadowChartTest, MeasuresEveryTechniqueAtEverySize) {
    const Scene scene = load_scene("spheres", 0.4f);
    std::size_t done = 0, all = 0;
    const auto progress = [&](std::size_t d, std::size_t a) { done = d, all = a; };
    const std::vector<ShadowRow> rows = measure_shadows(scene, small(), {}, progress);
    EXPECT_EQ(done, all);
    ASSERT_EQ(rows.size(), 4U);
    for (const ShadowRow& row : rows) {
        EXPECT_EQ(row.bits_per_texel, 224) << row.technique;
        EXPECT_GT(row.render.median, 0);
        EXPECT_GT(row.filter.median, 0);
        EXPECT_GT(row.shade.median, 0);
        ASSERT_TRUE(row.rmse.has_value());
        EXPECT_GT(*row.rmse, 1e-5) << "compared with a deep map";
        EXPECT_LT(*row.rmse, 0.1);
    }
    EXPECT_EQ(rows[0].map_size, 32);
    EXPECT_EQ(rows[3].map_size, 64);
    EXPECT_EQ(rows[3].technique, "power6-32");
    const std::vector<ShadowRow> again = measure_shadows(scene, small(), {}, progress);
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].rmse, again[i].rmse) << "errors repeat";
}

TEST_F(ShadowChartTest, StoppedIsEmpty) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(
        measure_shadows(load_scene("planes", 0.4f), small(), stop.get_token(), [](std::size_t, std::size_t) {
        }).empty());
}

TEST_F(ShadowChartTest, RatiosAreToFourierAtTheSameSizeAndScene) {
    const auto row = [](const char* scene, const char* technique, int size, double differential) {
        return ShadowRow{.scene = scene,
                         .technique = technique,
                         .map_size = size,
                         .bits_per_texel = 224,
                         .render = {1, 0},
                         .filter = {2, 0},
                         .shade = {30, 4},
                         .differential = {differential, 0},
                         .rmse = {}};
    };
    const std::vector<ShadowRow> rows = {row("a", "fourier-7", 64, 10), row("a", "power6-32", 64, 25),
                                         row("b", "fourier-7", 64, 50), row("b", "power6-32", 64, 25),
                                         row("b", "power6-32", 128, 25)};
    const std::string page = shadow_rows_to_markdown(rows);
    EXPECT_NE(page.find("| a | 64² | power6-32 | 224 | 1.0 ± 0.0 | 2.0 ± 0.0 | 30 ± 2 | 25 ± 0 | 2.50 | – |"),
              std::string::npos)
        << page;
    EXPECT_NE(page.find("| b | 64² | power6-32 | 224 | 1.0 ± 0.0 | 2.0 ± 0.0 | 30 ± 2 | 25 ± 0 | 0.50 | – |"),
              std::string::npos)
        << page;
    EXPECT_NE(page.find("| b | 128² | power6-32 | 224 | 1.0 ± 0.0 | 2.0 ± 0.0 | 30 ± 2 | 25 ± 0 | – | – |"),
              std::string::npos)
        << page;
    const std::string csv = shadow_rows_to_csv(rows);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 6);
    EXPECT_NE(csv.find("a,power6-32,64,224,1.000,0.000,2.000,0.000,30.000,4.000,25.000,0.000,\n"),
              std::string::npos)
        << csv;
}

}  // namespace
}  // namespace momentscope::test
