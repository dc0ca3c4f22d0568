// configuration_test.cpp -- techniques with parameters as text, and the grid of a chart.
#include "core/techniques/configuration.hpp"
#include "core/chart/grid.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>
#include <set>

using namespace momentscope;

namespace {

TEST(Configuration, TextHoldsWhatTheTechniqueReadsAndIsNotAtItsStandard) {
    ParameterValues values;
    values.set(ParameterId::nodes, 8.0f);
    values.set(ParameterId::layers, 2.0f);  // adaptive transparency has no such parameter
    EXPECT_EQ(configuration_text({&require_technique("at"), values}), "at:nodes=8");
    EXPECT_EQ(configuration_options({&require_technique("at"), values}), "--technique at --nodes 8");
    EXPECT_EQ(configuration_text({&require_technique("unsorted"), values}), "unsorted");
    EXPECT_EQ(configuration_text({&require_technique("at"), {}}), "at");
}

TEST(Configuration, TextsRoundTrip) {
    for (const Configuration& one : chart_grid()) {
        const std::string text = configuration_text(one);
        const Configuration read = parse_configuration(text);
        EXPECT_EQ(read.technique, one.technique);
        EXPECT_EQ(read.values, one.values) << text;
    }
    ParameterValues digits;
    digits.set(ParameterId::alpha, 1.23456789e-5f);
    digits.set(ParameterId::beta, 1.0f / 3);
    const Configuration odd = {&require_technique("power4-32"), digits};
    EXPECT_EQ(parse_configuration(configuration_text(odd)).values, digits) << configuration_text(odd);
}

TEST(Configuration, BaseHoldsForWhatTheTextDoesNotName) {
    ParameterValues base;
    base.set(ParameterId::beta, 0.5f);
    EXPECT_EQ(configuration_text(parse_configuration("power4-32:alpha=auto", base)), "power4-32:beta=0.5");
    EXPECT_EQ(configuration_text(parse_configuration("power4-32:beta=0.25", base)), "power4-32");
}

TEST(Configuration, WrongTextsAreRefused) {
    expect_error([] { parse_configuration("at9:nodes=4"); }, "no technique 'at9'");
    expect_error([] { parse_configuration("at:beta=0"); }, "'at' has no parameter 'beta'; use one of nodes");
    expect_error([] { parse_configuration("at:"); }, "no parameter ''");
    expect_error([] { parse_configuration("unsorted:beta=0"); }, "takes no parameters");
    expect_error([] { parse_configuration("at:nodes"); }, "at:nodes=VALUE");
    expect_error([] { parse_configuration("at:nodes=99"); }, "--nodes");
    expect_error([] { parse_configuration("at:nodes=4,nodes="); }, "--nodes");
    expect_error([] { parse_configuration("mt:resolution=half,read-format=nlqm32"); }, "cannot be filtered");
}

TEST(Configuration, ListsAreSplitBetweenConfigurationsNotParameters) {
    EXPECT_EQ(split_configurations("at:nodes=8,mt:resolution=half,read-format=theta16,wboit"),
              (std::vector<std::string>{"at:nodes=8", "mt:resolution=half,read-format=theta16", "wboit"}));
    EXPECT_EQ(split_configurations("nodes=8"), std::vector<std::string>{"nodes=8"});
    EXPECT_EQ(split_configurations("at,"), (std::vector<std::string>{"at", ""}));
}

TEST(Configuration, SecondMomentPassesDrawTheGeometryOnceMore) {
    EXPECT_EQ(geometry_passes(parse_configuration("mt")), 2);
    EXPECT_EQ(geometry_passes(parse_configuration("mt:moment-passes=opacity")), 3);
    EXPECT_EQ(geometry_passes(parse_configuration("unsorted")), 1);
}

TEST(Grid, HoldsEveryTechniqueFirstAsItIsAndNothingTwice) {
    std::set<std::string> texts;
    for (const Configuration& one : chart_grid()) EXPECT_TRUE(texts.insert(configuration_text(one)).second);
    for (const Technique& technique : techniques()) {
        EXPECT_TRUE(texts.contains(technique.id));
        EXPECT_EQ(configuration_text(chart_grid(technique).front()), technique.id);
    }
    EXPECT_EQ(chart_grid(require_technique("at")).size(), 3U);
    // A possible answer of advise --max-bits 160: two trigonometric moments without space for a factor.
    const Configuration lean = parse_configuration("trig2-32:factorisation=per-fragment");
    EXPECT_TRUE(texts.contains(configuration_text(lean)));
    EXPECT_EQ(bits_with_factor(*lean.technique, lean.values), 160);
    ParameterValues many;
    many.set(ParameterId::nodes, 8.0f);
    EXPECT_EQ(chart_grid(require_technique("at"), many).size(), 2U) << "at:nodes=8 is there already";
}

}  // namespace
