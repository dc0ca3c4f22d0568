// registry_test.cpp -- the registries of techniques and parameters, and the constants of Table 1 typed again.
#include "core/glsl.hpp"
#include "core/reference/exact_reconstruction.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"
#include "core/techniques/techniques_page.hpp"
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

struct ExpectedTechnique {
    float bias;
    int bits;
    int moment_count;
    int moment_floats;
    bool circle;  // trigonometric: a wrapping zone, and no bounds
};

// Table 1 of the supplementary for the biases; 32 or 16 bits for b0 and for each real moment.
const std::map<std::string, ExpectedTechnique> MOMENT_TECHNIQUES = {
    {"power4-32", {5e-7f, 160, 4, 4, false}},   {"power6-32", {5e-6f, 224, 6, 6, false}},
    {"power8-32", {5e-5f, 288, 8, 8, false}},   {"trig2-32", {4e-7f, 160, 2, 4, true}},
    {"trig3-32", {8e-7f, 224, 3, 6, true}},     {"trig4-32", {1.5e-6f, 288, 4, 8, true}},
    {"power4-16", {6e-5f, 80, 4, 4, false}},    {"power6-16", {6e-4f, 112, 6, 6, false}},
    {"power8-16", {2.5e-3f, 144, 8, 8, false}}, {"trig2-16", {4e-4f, 80, 2, 4, true}},
    {"trig3-16", {6.5e-4f, 112, 3, 6, true}},   {"trig4-16", {8.5e-4f, 144, 4, 8, true}},
    {"cheb4-32", {5e-7f, 160, 4, 4, false}},    {"cheb6-32", {5e-7f, 224, 6, 6, false}},
    {"cheb8-32", {5e-7f, 288, 8, 8, false}},
};

/// Lower-case words and digits, joined by single hyphens.
bool well_formed(const std::string& id) {
    return std::regex_match(id, std::regex("[a-z][a-z0-9]*(-[a-z0-9]+)*"));
}

/// A text for people: it begins with a capital or a `quoted` word and ends its last sentence.
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
        EXPECT_EQ(technique.geometry_passes == 0,
                  technique.path == RenderPath::peeling);  // grows with the layers
        EXPECT_EQ(find_technique(technique.id), &technique);
        EXPECT_EQ(&require_technique(technique.id), &technique);
    }
    for (const auto& [id, row] : MOMENT_TECHNIQUES) EXPECT_EQ(ids.count(id), 1u) << id;
    EXPECT_EQ(ids.count("sorted"), 1u);
}

TEST(Techniques, HaveTheirPage) {
    std::ifstream file("docs/techniques.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), techniques_page())
        << "momentscope list techniques --format markdown > docs/techniques.md";
}

TEST(Techniques, WithoutMomentsHaveMathFilesAndStatesThatFit) {
    int count = 0;
    for (const Technique& technique : techniques()) {
        if (technique.method == nullptr) continue;
        ++count;
        SCOPED_TRACE(technique.id);
        EXPECT_EQ(technique.kernel, nullptr);
        EXPECT_FALSE(technique.is_truth());
        EXPECT_TRUE(std::filesystem::exists(fmt::format("shaders/shared/{}.glsl", technique.math_file)));
        EXPECT_EQ(technique.geometry_passes, technique.method->holds_colors ? 1 : 2);
        const Accumulation how = technique.method->accumulation;
        EXPECT_EQ(technique.order_dependent, how == Accumulation::over || how == Accumulation::ordered);
        for (const ParameterId id : technique.parameters)
            for (float value = parameter(id).minimum; value <= parameter(id).maximum; ++value) {
                ParameterValues values;
                values.set(id, value);
                EXPECT_LE(technique.state_floats(technique.method_settings(values)), STATE_CAPACITY);
            }
    }
    EXPECT_EQ(count, 9);
}

TEST(Techniques, OfMomentsHaveTableOnesBiasAndTheirBits) {
    for (const auto& [id, expected] : MOMENT_TECHNIQUES) {
        SCOPED_TRACE(id);
        const Technique& technique = require_technique(id);
        EXPECT_EQ(technique.recommended_bias, expected.bias);
        EXPECT_EQ(technique.bits_per_pixel, expected.bits);
        EXPECT_EQ(technique.moment_count, expected.moment_count);
        ASSERT_NE(technique.kernel, nullptr);
        EXPECT_EQ(technique.kernel->moment_floats, expected.moment_floats);
        EXPECT_EQ(technique.kernel->node_count, expected.moment_floats / 2);
        EXPECT_EQ(technique.has_bounds, !expected.circle);
        EXPECT_EQ(technique.uses(ParameterId::theta), expected.circle);
        EXPECT_EQ(technique.path, RenderPath::moments);
        EXPECT_EQ(technique.geometry_passes, 2);
        EXPECT_EQ(technique.order_dependent, technique.kernel->bits == 16);  // rounded after every fragment
        EXPECT_EQ(technique.uses(ParameterId::accumulation), technique.kernel->bits == 32);
        EXPECT_EQ(technique.uses(ParameterId::solver), id.find("cheb") == std::string::npos);
        EXPECT_TRUE(
            std::filesystem::exists(std::string("shaders/shared/") + technique.basis + "_moments.glsl"));
        for (const ParameterId id_used : {ParameterId::beta, ParameterId::alpha, ParameterId::renormalize})
            EXPECT_TRUE(technique.uses(id_used));
        EXPECT_FALSE(technique.uses(ParameterId::opacity));  // the scene's
    }
}

TEST(Techniques, SortedIsTheTruthWithoutMoments) {
    const Technique& sorted = require_technique("sorted");
    EXPECT_EQ(sorted.kernel, nullptr);
    EXPECT_EQ(sorted.path, RenderPath::sorted);
    EXPECT_TRUE(sorted.parameters.empty());
    EXPECT_EQ(sorted.moment_count, 0);
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
    for (const auto& [id, expected] : MOMENT_TECHNIQUES)
        EXPECT_EQ(resolve(values, require_technique(id)).alpha, expected.bias) << id;
    values.set(ParameterId::alpha, 0.0f);  // a set 0 is no `auto`
    values.set(ParameterId::beta, 0.75f);
    values.set(ParameterId::theta, 0.5f);
    values.set(ParameterId::renormalize, 0.0f);
    const ResolvedParameters resolved = resolve(values, require_technique("trig3-32"));
    EXPECT_EQ(resolved.alpha, 0.0f);
    EXPECT_EQ(resolved.beta, 0.75f);
    EXPECT_EQ(resolved.theta, 0.5f);
    EXPECT_FALSE(resolved.renormalize);
    EXPECT_TRUE(resolve(ParameterValues(), require_technique("power4-32")).renormalize);
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
        const float standard = row.standard.value_or(row.minimum);
        EXPECT_TRUE(row.minimum <= standard && standard <= row.maximum);
        EXPECT_NE(row.invalidates, Stage::nothing);
    }
    EXPECT_EQ(find_parameter(""), nullptr);
    EXPECT_EQ(find_parameter("Beta"), nullptr);
}

TEST(Parameters, HaveThePapersDefaults) {
    EXPECT_EQ(parameter(ParameterId::beta).standard, 0.25f);
    EXPECT_NEAR(*parameter(ParameterId::theta).standard, 0.314159265f, 1e-7f);  // pi / 10, to an ulp or two
    EXPECT_EQ(parameter(ParameterId::alpha).standard, std::nullopt);
    EXPECT_EQ(parameter(ParameterId::renormalize).standard, 1.0f);
    for (const Technique& technique : techniques()) {  // so that what `auto` means can also be typed
        EXPECT_GE(technique.recommended_bias, parameter(ParameterId::alpha).minimum);
        EXPECT_LE(technique.recommended_bias, parameter(ParameterId::alpha).maximum);
    }
}

/// (1, b*_1, ..., b*_M) of a shader's table.
template <std::size_t M>
reference::PowerMoments<M, double> bias_moments(const float (&table)[M]) {
    reference::PowerMoments<M, double> moments{1};
    for (std::size_t i = 0; i < M; ++i) moments[i + 1] = static_cast<double>(table[i]);
    return moments;
}

/// The smallest pivot of the Hankel matrix of b*: positive where b* is interior, that is, where bias helps.
template <std::size_t M>
double least_pivot(const reference::PowerMoments<M, double>& moments) {
    const auto factor = reference::factor_power<M, double>(moments);
    return factor ? std::ranges::min(factor->hankel.pivot) : -1;
}

TEST(BiasMoments, LieInsideTheMomentSpace) {
    // Half of the last digit named is the tolerance: the papers' last printed digit matters.
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
    moments[6] = 0.64;  // for .63, as others have it
    EXPECT_LT(least_pivot<8>(moments), 0);
}

}  // namespace
