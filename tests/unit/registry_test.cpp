// registry_test.cpp -- the registries of techniques and parameters, and the constants of Table 1, typed
// again.
#include "core/reference/exact_reconstruction.hpp"
#include "core/report/techniques_page.hpp"
#include "core/support/glsl.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"
#include "tests/unit/expect_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#define SHARED_NAME bias4_16
#define MOMENT_COUNT 4
#define MOMENT_BITS 16
#include "tests/unit/shared_power.inl"
#define SHARED_NAME bias4_32
#define MOMENT_COUNT 4
#define MOMENT_BITS 32
#include "tests/unit/shared_power.inl"
#define SHARED_NAME bias6_16
#define MOMENT_COUNT 6
#define MOMENT_BITS 16
#include "tests/unit/shared_power.inl"
#define SHARED_NAME bias6_32
#define MOMENT_COUNT 6
#define MOMENT_BITS 32
#include "tests/unit/shared_power.inl"
#define SHARED_NAME bias8_16
#define MOMENT_COUNT 8
#define MOMENT_BITS 16
#include "tests/unit/shared_power.inl"
#define SHARED_NAME bias8_32
#define MOMENT_COUNT 8
#define MOMENT_BITS 32
#include "tests/unit/shared_power.inl"

using namespace momentscope;

namespace {

// Table 1 of the supplementary. Chebyshev moments are not in it and take the smallest of its biases.
const std::map<std::string, float> TABLE_1 = {
    {"power4-32", 5e-7f},   {"power6-32", 5e-6f},  {"power8-32", 5e-5f},  {"trig2-32", 4e-7f},
    {"trig3-32", 8e-7f},    {"trig4-32", 1.5e-6f}, {"power4-16", 6e-5f},  {"power6-16", 6e-4f},
    {"power8-16", 2.5e-3f}, {"trig2-16", 4e-4f},   {"trig3-16", 6.5e-4f}, {"trig4-16", 8.5e-4f},
    {"cheb4-32", 5e-7f},    {"cheb6-32", 5e-7f},   {"cheb8-32", 5e-7f},
};

/// Lower-case words and digits, joined by single hyphens.
bool well_formed(const std::string& id) {
    return std::regex_match(id, std::regex("[a-z][a-z0-9]*(-[a-z0-9]+)*"));
}

/// A text for people: it begins with a capital letter or a digit and ends with a full stop.
void expect_prose(const std::string& text) {
    ASSERT_GT(text.size(), 20u);
    EXPECT_TRUE(std::isdigit(text[0]) != 0 || std::isupper(text[0]) != 0) << text;
    EXPECT_EQ(text.back(), '.') << text;
    EXPECT_EQ(text.find("  "), std::string::npos) << text;
}

TEST(Techniques, HaveUniqueWellFormedIdsAndFullRows) {
    std::set<std::string> ids;
    for (const Technique& technique : techniques()) {
        SCOPED_TRACE(technique.id);
        EXPECT_TRUE(ids.insert(technique.id).second);
        EXPECT_TRUE(well_formed(technique.id));
        EXPECT_FALSE(std::string(technique.name).empty());
        expect_prose(technique.description);
        EXPECT_TRUE(std::regex_search(technique.source, std::regex("(19|20)[0-9][0-9]"))) << "names a year";
        EXPECT_EQ(technique.geometry_passes == 0, technique.id == std::string("peeling"))
            << "grows with the layers";
        EXPECT_EQ(find_technique(technique.id), &technique);
        EXPECT_EQ(&require_technique(technique.id), &technique);
    }
    for (const auto& [id, bias] : TABLE_1) EXPECT_EQ(ids.count(id), 1u) << id;
}

TEST(Techniques, HaveTheirPage) {
    std::ifstream file("docs/techniques.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), techniques_page())
        << "momentscope list techniques --format markdown > docs/techniques.md";
}

TEST(Techniques, WithoutMomentsHaveStatesThatFit) {
    for (const Technique& technique : techniques()) {
        if (!technique.has_pixel_states()) continue;
        SCOPED_TRACE(technique.id);
        for (const ParameterId id : technique.parameters)
            for (float value = parameter(id).minimum; value <= parameter(id).maximum; ++value) {
                ParameterValues values;
                values.set(id, value);
                EXPECT_LE(technique.pixel_states().floats(resolve(values, technique).settings),
                          STATE_CAPACITY);
            }
    }
}

// The id tells what is stored: power4-16 stores four real moments and b0 with 16 bits each, trig2-32 two
// complex ones.
TEST(Techniques, OfMomentsHaveTableOnesBiasAndTheBitsOfTheirId) {
    for (const auto& [id, bias] : TABLE_1) {
        SCOPED_TRACE(id);
        const Technique& technique = require_technique(id);
        EXPECT_EQ(technique.moments().recommended_bias, bias);
        const int count = id[id.find('-') - 1] - '0', bits = std::stoi(id.substr(id.find('-') + 1));
        const bool circle = id.starts_with("trig");
        const int numbers = circle ? 2 * count : count;
        EXPECT_EQ(stored_bits(technique, {}), (numbers + 1) * bits);
        // A factor of m real moments has m numbers; one of m complex moments has m complex and m real ones.
        const int factor = circle && bits == 32 ? 3 * count : numbers;
        EXPECT_EQ(bits_with_factor(technique, {}), (factor + 1) * bits);
        ParameterValues per_fragment;
        per_fragment.set(Factorisation::per_fragment);
        EXPECT_EQ(bits_with_factor(technique, per_fragment), stored_bits(technique, {}));
        EXPECT_EQ(technique.moments().moment_count, count);
        EXPECT_EQ(technique.moment_kernel().moment_floats, numbers);
        EXPECT_EQ(technique.moment_kernel().bits, bits);
        EXPECT_EQ(technique.has_bounds(), !circle) << "Algorithm 2 gives none";
        EXPECT_EQ(technique.order_dependent, bits == 16) << "rounded after every fragment";
    }
}

TEST(Techniques, UnknownIdListsAllOfThem) {
    EXPECT_EQ(find_technique("power4"), nullptr);
    EXPECT_EQ(find_technique(""), nullptr);
    EXPECT_EQ(find_technique("POWER4-32"), nullptr);
    for (const Technique& technique : techniques())
        expect_error([] { require_technique("power5-32"); }, technique.id);
    expect_error([] { require_technique("power5-32"); }, "'power5-32'");
}

TEST(Techniques, ResolveAutoToTheirOwnBiasAndKeepWhatIsSet) {
    ParameterValues values;
    for (const auto& [id, bias] : TABLE_1)
        EXPECT_EQ(resolve(values, require_technique(id)).alpha, bias) << id;
    values.set(ParameterId::alpha, 0.0f);  // an explicit 0 is not `auto`
    values.set(ParameterId::beta, 0.75f);
    values.set(ParameterId::theta, 0.5f);
    values.set(Renormalization::off);
    const ResolvedParameters resolved = resolve(values, require_technique("trig3-32"));
    EXPECT_EQ(resolved.alpha, 0.0f);
    EXPECT_EQ(resolved.beta, 0.75f);
    EXPECT_EQ(resolved.theta, 0.5f);
    EXPECT_FALSE(resolved.renormalizes());
    EXPECT_TRUE(resolve(ParameterValues(), require_technique("power4-32")).renormalizes());
}

TEST(Parameters, HaveFullRowsWhoseRangesContainTheirDefaults) {
    ASSERT_EQ(parameters().size(), PARAMETER_COUNT);
    std::set<std::string> keys;
    for (std::size_t i = 0; i < PARAMETER_COUNT; ++i) {
        const Parameter& row = parameters()[i];
        SCOPED_TRACE(row.key);
        EXPECT_EQ(static_cast<std::size_t>(row.id), i);
        EXPECT_EQ(&parameter(row.id), &row);
        EXPECT_EQ(find_parameter(row.key), &row);
        EXPECT_TRUE(keys.insert(row.key).second);
        EXPECT_TRUE(well_formed(row.key));
        EXPECT_FALSE(std::string(row.symbol).empty());
        EXPECT_FALSE(std::string(row.name).empty());
        EXPECT_FALSE(std::string(row.source).empty());
        expect_prose(row.help);
        EXPECT_LT(row.minimum, row.maximum);
        const float default_value = row.default_value.value_or(row.minimum);
        EXPECT_TRUE(row.minimum <= default_value && default_value <= row.maximum);
        EXPECT_NE(row.invalidates, Stage::nothing);
    }
    EXPECT_EQ(find_parameter(""), nullptr);
    EXPECT_EQ(find_parameter("Beta"), nullptr);
}

TEST(Parameters, HaveThePapersDefaults) {
    EXPECT_EQ(parameter(ParameterId::beta).default_value, 0.25f);
    EXPECT_NEAR(*parameter(ParameterId::theta).default_value, 0.314159265f,
                1e-7f);  // pi / 10, to an ulp or two
    EXPECT_EQ(parameter(ParameterId::alpha).default_value, std::nullopt);
    EXPECT_EQ(parameter(ParameterId::renormalize).default_value, 1.0f);
    for (const Technique* technique :
         moment_based_techniques())  // so that the value of `auto` can also be typed
        for (const float bias : {technique->moments().recommended_bias, technique->moments().robust_bias}) {
            EXPECT_GE(bias, parameter(ParameterId::alpha).minimum);
            EXPECT_LE(bias, parameter(ParameterId::alpha).maximum);
        }
}

/// (1, b*_1, ..., b*_M) from the table of a shader.
template <std::size_t M>
reference::PowerMoments<M, double> bias_moments(const float (&table)[M]) {
    reference::PowerMoments<M, double> moments{1};
    for (std::size_t i = 0; i < M; ++i) moments[i + 1] = static_cast<double>(table[i]);
    return moments;
}

/// The smallest pivot of the Hankel matrix of b*. It is positive if b* is interior, which makes bias
/// effective.
template <std::size_t M>
double least_pivot(const reference::PowerMoments<M, double>& moments) {
    const auto factor = reference::factor_power<M, double>(moments);
    return factor ? std::ranges::min(factor->hankel.pivot) : -1;
}

TEST(BiasMoments, LieInsideTheMomentSpace) {
    // The tolerance is half of the last printed digit, because the digits printed in the papers matter.
    EXPECT_NEAR(least_pivot<4>(bias_moments(glsl::bias4_16::BIAS_MOMENTS)), 0.234, 0.0005);
    EXPECT_NEAR(least_pivot<4>(bias_moments(glsl::bias4_32::BIAS_MOMENTS)), 0.234, 0.0005);
    EXPECT_NEAR(least_pivot<6>(bias_moments(glsl::bias6_16::BIAS_MOMENTS)), 0.049, 0.0005);
    EXPECT_NEAR(least_pivot<6>(bias_moments(glsl::bias6_32::BIAS_MOMENTS)), 0.026, 0.0005);
    EXPECT_NEAR(least_pivot<8>(bias_moments(glsl::bias8_16::BIAS_MOMENTS)), 0.00038, 0.000005);
    EXPECT_NEAR(least_pivot<8>(bias_moments(glsl::bias8_32::BIAS_MOMENTS)), 0.011, 0.0005);
}

TEST(BiasMoments, AreThoseOfTableOne) {
    using Four = std::array<float, 4>;
    using Six = std::array<float, 6>;
    using Eight = std::array<float, 8>;
    EXPECT_EQ(std::to_array(glsl::bias4_16::BIAS_MOMENTS), (Four{0, 0.628f, 0, 0.628f}));
    EXPECT_EQ(std::to_array(glsl::bias6_16::BIAS_MOMENTS), (Six{0, 0.5566f, 0, 0.489f, 0, 0.47869382f}));
    EXPECT_EQ(std::to_array(glsl::bias8_16::BIAS_MOMENTS),
              (Eight{0, 0.424749164f, 0, 0.224078027f, 0, 0.153692308f, 0, 0.129004405f}));
    EXPECT_EQ(std::to_array(glsl::bias4_32::BIAS_MOMENTS), (Four{0, 0.375f, 0, 0.375f}));
    EXPECT_EQ(std::to_array(glsl::bias6_32::BIAS_MOMENTS), (Six{0, 0.48f, 0, 0.451f, 0, 0.45f}));
    EXPECT_EQ(std::to_array(glsl::bias8_32::BIAS_MOMENTS),
              (Eight{0, 0.75f, 0, 0.67666666666666664f, 0, 0.63f, 0, 0.60030303030303034f}));
}

TEST(BiasMoments, WithTheKnownMisprintLieOutside) {
    auto moments = bias_moments(glsl::bias8_32::BIAS_MOMENTS);
    EXPECT_GT(least_pivot<8>(moments), 0);
    moments[6] = 0.64;  // instead of 0.63, as other implementations have it
    EXPECT_LT(least_pivot<8>(moments), 0);
}

}  // namespace
