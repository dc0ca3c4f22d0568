// shadow_settings_test.cpp -- the light's choices, and which stages they make stale.
#include "core/shadow/shadow_settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/render/view.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

TEST(ShadowSettings, ThePlotOfOpaqueCastersHasTheBiasOfTheirMap) {
    const auto configuration_of = [](const char* id) {
        const auto row = static_cast<float>(&require_opaque_shadow(id) - opaque_shadows().data());
        return opaque_configuration(values_with({{ParameterId::opaque_shadow, row}}));
    };
    for (const auto& [id, technique, bias] : {std::tuple("hamburger-32", "power4-32", 3e-7f),
                                              {"hamburger-16", "power4-32", 6e-5f},
                                              {"hausdorff", "power4-32", 3e-7f},
                                              {"trigonometric", "trig2-32", 4e-7f}}) {
        const Configuration configuration = configuration_of(id);
        EXPECT_STREQ(configuration.technique->id, technique) << id;
        EXPECT_EQ(configuration.values[ParameterId::alpha], bias) << id;
    }
    EXPECT_EQ(configuration_of("trigonometric").values[ParameterId::theta], 0.314159265f);
    EXPECT_STREQ(configuration_of("pcf").technique->id, "sorted");
}

TEST(ShadowSettings, EveryChoiceMeansATechnique) {
    const Parameter& row = parameter(ParameterId::shadow_technique);
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const Configuration configuration = light_configuration(
            values_with({{row.id, static_cast<float>(i)}, {ParameterId::shadow_beta, 0.5f}}));
        const std::string_view id = row.choices[i];
        if (id.starts_with("fourier-")) {
            EXPECT_STREQ(configuration.technique->id, "fourier");
            EXPECT_EQ(texel_numbers(configuration), id == "fourier-7" ? 7 : 15);
        } else if (id != "deep" && id != "none") {
            EXPECT_EQ(configuration.technique->id, id);
            EXPECT_EQ(configuration.values[ParameterId::beta], 0.5f);
            EXPECT_EQ(configuration.technique->id, row.choices[i]);
        }
    }
    for (const Technique* technique : kernel_techniques()) {
        const bool offered =
            std::ranges::find(row.choices, std::string_view(technique->id)) != row.choices.end();
        EXPECT_EQ(offered, std::string_view(technique->id).find("-16") == std::string_view::npos)
            << technique->id;
    }
    const Parameter& opaque = parameter(ParameterId::opaque_shadow);
    ASSERT_EQ(opaque.choices.size(), opaque_shadows().size());
    for (std::size_t i = 0; i < opaque.choices.size(); ++i)
        EXPECT_STREQ(opaque.choices[i], opaque_shadows()[i].id);
    EXPECT_STREQ(shadow_settings({}, {}).opaque->id, "hamburger-16") << "the paper's choice";
    expect_error([] { require_opaque_shadow("psm"); }, "pcf");
}

TEST(FirstStaleStage, OfShadowsIsThatOfColours) {
    const View view = {{}, {64, 64}, &require_technique("power6-32"), {}};
    const auto changed = [&](View base, const ParameterSettings& settings) {
        View after = base;
        for (const auto& [id, value] : settings) after.parameters.set(id, value);
        return first_stale_stage(base, after);
    };
    using enum ParameterId;
    EXPECT_EQ(changed(view, {{shadows, 1}}), Stage::shading);
    EXPECT_EQ(changed(view, {{shadow_beta, 0.5f}}), Stage::nothing) << "without shadows";
    View lit = view;
    lit.parameters.set(shadows, 1.0f);
    for (const ParameterId id : SHADOW_PARAMETERS)
        EXPECT_EQ(changed(lit, {{id, parameter(id).minimum +
                                         (parameter(id).scale == Scale::whole ? 1.0f : 0.5f) *
                                             (parameter(id).scale != Scale::choice ? 1.0f : 0.0f)}}),
                  Stage::shading)
            << parameter(id).key;
    EXPECT_EQ(changed(lit, {{shadows, 0}}), Stage::shading);
    EXPECT_EQ(changed(lit, {{light_azimuth, Light().azimuth}}), Stage::shading) << "a scene may have another";
    EXPECT_EQ(changed(lit, {{beta, 0.5f}}), Stage::color) << "the eye's alone";
    EXPECT_EQ(changed(lit, {{theta, 0.5f}}), Stage::nothing) << "power moments read none";
    EXPECT_EQ(changed(lit, {{renormalize, 0}}), Stage::composite)
        << "nor is this any of the light's business";
    EXPECT_EQ(changed(lit, {{solver, 1}}), Stage::color);
    EXPECT_EQ(changed(lit, {{alpha, 1e-3f}}), Stage::shading) << "alpha is that of both";
    View series = lit;
    series.parameters.set(shadow_technique, *parse_parameter(parameter(shadow_technique), "fourier-7"));
    EXPECT_EQ(changed(series, {{alpha, 1e-3f}}), Stage::color) << "which a series does not have";
    EXPECT_EQ(changed(series, {{lanczos, 1}}), Stage::shading);
    EXPECT_EQ(changed(series, {{coefficients, 1}}), Stage::nothing)
        << "the eye's series has other coefficients";
    lit.parameters.set(shadow_technique, *parse_parameter(parameter(shadow_technique), "trig3-32"));
    EXPECT_EQ(changed(lit, {{theta, 0.5f}}), Stage::shading) << "the light's moments do";
    lit.technique = &require_technique("wboit");
    EXPECT_EQ(changed(lit, {{shadow_beta, 0.5f}}), Stage::opaque) << "its first pass stores colours";
    View both = lit;
    both.technique = &require_technique("power4-32");
    both.parameters.set(shadow_beta, 0.7f);
    EXPECT_EQ(first_stale_stage(lit, both), Stage::opaque) << "new moments, and opaque surfaces shaded anew";
}

}  // namespace
}  // namespace momentscope::test
