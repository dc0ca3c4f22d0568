// chart_test.cpp -- processing of a chart's numbers: medians, the Pareto front, tables and drawings.
#include "core/chart/chart.hpp"
#include "core/chart/chart_csv.hpp"
#include "core/chart/grid.hpp"
#include "core/chart/pareto.hpp"
#include "core/report/chart_drawing.hpp"
#include "core/report/chart_html.hpp"
#include "core/report/family.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/markup.hpp"
#include "tests/unit/expect_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace momentscope;

namespace {

using Indices = std::vector<std::size_t>;

TEST(Pareto, OfAHandfulOfPoints) {
    const std::vector<glm::dvec2> points = {{1, 10}, {2, 5}, {3, 7}, {4, 5}, {5, 1}, {9, 1.5}, {6, 1}};
    EXPECT_EQ(pareto_front(points), (Indices{0, 1, 4}));
    EXPECT_EQ(pareto_front(std::vector<glm::dvec2>{{1, 1}, {1, 1}, {1, 2}}), (Indices{0, 1}))
        << "equal points";
    EXPECT_TRUE(pareto_front({}).empty());
    const double none = std::numeric_limits<double>::infinity();
    EXPECT_EQ(pareto_front(std::vector<glm::dvec2>{{none, 0}, {std::nan(""), 0}, {2, 2}}), Indices{2});
}

TEST(Pareto, AgreesWithTheDefinition) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> whole(0, 20);  // so that coordinates are often equal
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i < 30; ++i) points.emplace_back(whole(random), whole(random));
        Indices wanted;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::ranges::none_of(points, [&](const glm::dvec2& p) {
                    return p.x <= points[i].x && p.y <= points[i].y && p != points[i];
                }))
                wanted.push_back(i);
        Indices front = pareto_front(points);
        std::ranges::sort(front);
        EXPECT_EQ(front, wanted);
    }
}

TEST(Spread, IsMedianAndQuartiles) {
    EXPECT_EQ(spread_of({5}), (Spread{5, 0}));
    EXPECT_EQ(spread_of({4, 1, 3, 2, 100}), (Spread{3, 2}));
    EXPECT_EQ(spread_of({1, 2}), (Spread{1.5, 0.5}));
}

ChartRow row_of(const std::string& scene, const std::string& configuration, double total, double error) {
    ChartNumbers numbers = {.moments = {0.25 * total, 0.5},
                            .color = {0.5 * total, 1},
                            .composite = {0.25 * total, 0.125},
                            .total = {total, 2},
                            .differential = {total - 10, 3},
                            .stored_bits = 144,
                            .bits_with_factor = 160,
                            .geometry_passes = 2,
                            .rmse = error,
                            .delta_e = 100 * error,
                            .flip = 2 * error,
                            .stability = 0.0625 * error};
    return {scene, configuration, "", numbers};
}

Chart some_chart() {
    Chart chart = {begin_settings("chart", CHART_SCHEMA, 5, {}), {}};
    chart.settings.insert(chart.settings.end(), {{"size", "64x36"},
                                                 {"times", "from glFinish to glFinish"},
                                                 {"parameters", "order=reversed order-seed=1 opacity=0.4"}});
    chart.rows = {row_of("teapots", "unsorted", 10, 0.25),
                  row_of("teapots", "at:nodes=8", 20, 0.0625),
                  row_of("teapots", "mt:resolution=half,read-format=theta16", 40, 0.125),
                  row_of("a \"b\", c.obj", "unsorted", 10, 0.5),
                  {"teapots", "power4-16", "This GL has no <order>, so there.", {}}};
    std::swap(chart.rows[3], chart.rows[4]);
    chart.rows[1].numbers->stored_bits = std::nullopt;
    chart.rows[1].numbers->bits_with_factor = std::nullopt;
    chart.rows[1].numbers->geometry_passes = std::nullopt;
    return chart;
}

RunTable table_of(const Chart& chart) {
    RunTable table = {chart.settings, chart_columns(), {}};
    for (const ChartRow& row : chart.rows) table.rows.push_back(chart_line(row));
    return table;
}

TEST(ChartCsv, RowsRoundTrip) {
    const Chart chart = some_chart();
    EXPECT_EQ(chart_of(table_of(chart), "x").rows, chart.rows);
    EXPECT_EQ(std::ranges::count(chart_columns(), ','), 19);
}

TEST(ChartCsv, DamageIsNamed) {
    RunTable table = table_of(some_chart());
    table.rows[1] = "\"teapots\",\"at\",1,2,x";
    expect_error([&] { chart_of(table, "x.csv"); }, "'x.csv' is damaged");
    table.rows[1] = chart_line(some_chart().rows[0]).replace(20, 1, "x");
    expect_error([&] { chart_of(table, "x.csv"); }, "'x.csv' is damaged");
    table.settings[1].second = "99";
    expect_error([&] { chart_of(table, "x.csv"); }, "schema 99");
    table.settings[0].second = "stress";
    expect_error([&] { chart_of(table, "x.csv"); }, "not of chart");
}

// Fields that an axis or a table could not handle, one for each kind.
TEST(ChartCsv, OnlyFiniteNumbersInTheirRangeAreRead) {
    const std::string line = chart_line(row_of("s", "at", 1, 1));  // after its names: moments, ...
    std::vector<std::string> fields = csv_fields(line);
    for (const char* wrong : {"inf", "-inf", "nan", "-nan", "1e999", "1e300", "-1"})
        for (std::size_t i = 2; i < fields.size() - 1; ++i) {
            if (i == 10 && std::string_view(wrong) == "-1") continue;  // a difference may be negative
            std::vector<std::string> damaged = fields;
            damaged[i] = wrong;
            expect_error([&] { parse_chart_line(fmt::format("{}", fmt::join(damaged, ",")), "x.csv"); },
                         fmt::format("'x.csv' is damaged at '{}'", wrong));
        }
}

TEST(ChartOutputs, DrawErrorsThatAreNoFiniteNumbers) {
    for (const double error : {std::numeric_limits<double>::infinity(), std::nan(""), 1.7e308, -1.0}) {
        Chart chart = some_chart();
        chart.rows[1].numbers->rmse = error;
        chart.rows[0].numbers->total.median = 0;
        const std::string svg = chart_to_svg(chart, Metric::rmse);
        EXPECT_EQ(svg.find("=\"nan"), std::string::npos) << error;
        EXPECT_EQ(svg.find("=\"-nan"), std::string::npos) << error;
        EXPECT_EQ(svg.find("=\"inf"), std::string::npos) << error;
        EXPECT_EQ(svg.find("=\"-inf"), std::string::npos) << error;
        EXPECT_EQ(svg.find("inf,"), std::string::npos) << error;
        EXPECT_EQ(svg.find("nan,"), std::string::npos) << error;
    }
}

TEST(ChartOutputs, HoldEveryRowAndNeedNoOtherFile) {
    const Chart chart = some_chart();
    const std::string markdown = chart_to_markdown(chart, Metric::rmse);
    EXPECT_NE(markdown.find(
                  "**`at:nodes=8`** | 5.0 | 10.0 | 5.0 | 20.0 (2.0) | 10.0 (3.0) | grows | grows | layers |"),
              std::string::npos)
        << markdown;
    EXPECT_NE(markdown.find("| `mt:resolution=half,read-format=theta16` |"), std::string::npos)
        << "not on the front";
    const std::string html = chart_to_html(chart, Metric::flip);
    for (const ChartRow& row : chart.rows) EXPECT_NE(html.find(row.configuration), std::string::npos);
    EXPECT_EQ(html.find("src="), std::string::npos) << "self-contained";
    EXPECT_EQ(html.find("<order>"), std::string::npos) << "escaped";
    EXPECT_NE(html.find("momentscope explore --scene teapots --technique at --nodes 8 --order reversed"),
              std::string::npos);
    EXPECT_EQ(explore_command(chart, chart.rows[4]),
              fmt::format("momentscope explore --scene '{}' --technique unsorted --order reversed",
                          absolute_scene("a \"b\", c.obj")));
    EXPECT_EQ(short_name("mt:resolution=half,read-format=theta16"), "mt half theta16");
    EXPECT_EQ(short_name("at:nodes=8"), "at nodes=8");
}

TEST(ChartDrawing, LabelsOverlapNeitherMarksNorEachOtherNorTheEdge) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<ChartRow> rows;
    for (const Configuration& one : chart_grid())
        rows.push_back(row_of("teapots", configuration_text(one), 20 * std::pow(100, share(random)),
                              0.001 * std::pow(60, share(random))));
    rows[3].numbers->rmse = 0;  // 0 has no logarithm
    const Drawing drawing = chart_drawing(rows, Metric::rmse, "by hand");
    std::size_t labels = 0;
    for (const Drawing::Text& text : drawing.texts) {
        const glm::vec2 extent(text_width(text.text, text.size), text.size);
        EXPECT_GE(text.at.x, 0) << text.text;
        EXPECT_LE(text.at.x + extent.x, drawing.size.x) << text.text;
        for (const Drawing::Text& other : drawing.texts) {
            if (&other == &text) continue;
            EXPECT_FALSE(std::abs(text.at.y - other.at.y) < 0.9f * text.size && text.at.x < other.at.x + 1 &&
                         other.at.x < text.at.x + extent.x)
                << text.text << " and " << other.text;
        }
        const auto names = [&](const ChartRow& row) { return short_name(row.configuration) == text.text; };
        labels += std::ranges::any_of(rows, names) ? 1 : 0;
        for (const Drawing::Mark& mark : drawing.marks) {
            if (mark.row == Drawing::NO_ROW) continue;
            EXPECT_FALSE(mark.at.x > text.at.x && mark.at.x < text.at.x + extent.x &&
                         std::abs(mark.at.y - text.at.y) < 0.5f * extent.y)
                << text.text;
        }
    }
    EXPECT_GT(labels, rows.size() * 3 / 4) << "most names have room";
    std::size_t marks = 0;
    for (const Drawing::Mark& mark : drawing.marks) marks += mark.row != Drawing::NO_ROW ? 1 : 0;
    EXPECT_EQ(marks, rows.size());
}

TEST(Families, HoldEveryTechniqueWithMomentsByItsBasisOrByWhatItKnows) {
    for (const Technique* technique : moment_based_techniques()) {
        const std::string_view name = family_of(*technique).name;
        const std::string_view id = technique->id;
        EXPECT_NE(name.find("moments"), std::string_view::npos) << id << " is among " << name;
        EXPECT_EQ(name == "moments and ends", id.starts_with("certain")) << id;
        EXPECT_EQ(name == "moments of the own interval", id.starts_with("sharp")) << id;
        const bool by_basis = !technique->moments().estimation.has_value();
        EXPECT_EQ(name.starts_with("Chebyshev"), by_basis && technique->is_of(BasisFamily::chebyshev)) << id;
    }
}

TEST(ChartDrawing, BearsScenesWithoutNumbers) {
    const ChartRow none = {"teapots", "power4-16", "No.", {}};
    EXPECT_TRUE(chart_drawing({&none, 1}, Metric::rmse, "").marks.empty());
    const ChartRow exact = row_of("teapots", "sorted", 0, 0);
    EXPECT_FALSE(chart_drawing({&exact, 1}, Metric::rmse, "").marks.empty());
}

// Rows come from files as well as from measurements. For all values, the axes must be finite.
TEST(ChartDrawing, LeavesOutWhatHasNoPlaceOnAnAxis) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double none : {infinite, -infinite, std::nan("")}) {
        std::vector<ChartRow> rows = {row_of("teapots", "unsorted", none, 1),
                                      row_of("teapots", "wboit", 1, none), row_of("teapots", "at", 2, 0.5)};
        const Drawing drawing = chart_drawing(rows, Metric::rmse, "");
        for (const Drawing::Mark& mark : drawing.marks)
            EXPECT_TRUE(mark.row == 2 || mark.row == Drawing::NO_ROW) << mark.row;
        for (const Drawing::Line& one : drawing.lines)
            for (const glm::vec2& point : one.points)
                EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
    }
    const ChartRow wide = row_of("teapots", "at", 3e38, 3e38);
    EXPECT_LT(chart_drawing({&wide, 1}, Metric::rmse, "").lines.size(), 100U);
}

}  // namespace
