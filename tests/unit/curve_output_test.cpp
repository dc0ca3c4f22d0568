// curve_output_test.cpp -- curves as JSON (the form that other people's scripts depend on), as CSV and as a
// table.
#include "core/report/curve_output.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>

using namespace momentscope;
using nlohmann::ordered_json;

namespace {

/// Fragments of opacity one half at -0.5 and three quarters at 0.5.
ViewRay two_fragments() {
    ViewRay ray;
    for (const auto& [depth, opacity] : {std::pair{-0.5f, 0.5f}, {0.5f, 0.75f}}) {
        Fragment fragment;
        fragment.depth = fragment.view_depth = depth;
        fragment.opacity = opacity;
        ray.fragments.push_back(fragment);
    }
    return ray;
}

Curve curve_of(const ViewRay& ray, const char* technique, std::size_t samples = 5) {
    return sample_curve(ray, require_technique(technique), ParameterValues(), even_depths(samples));
}

ordered_json json_of(const ViewRay& ray, const std::vector<Curve>& curves) {
    return ordered_json::parse(curves_to_json(ray, curves));
}

ordered_json json_curve(const char* technique) {
    const ViewRay ray = two_fragments();
    return json_of(ray, {curve_of(ray, technique)})["curves"][0];
}

std::vector<std::string> keys_of(const ordered_json& object) {
    std::vector<std::string> keys;
    for (const auto& entry : object.items()) keys.push_back(entry.key());
    return keys;
}

using Keys = std::vector<std::string>;

TEST(CurveJson, NamesTheRayAndItsTotal) {
    const ViewRay ray = two_fragments();
    const ordered_json root = json_of(ray, {});
    EXPECT_EQ(keys_of(root), (Keys{"ray", "curves"}));
    EXPECT_EQ(root["ray"]["fragments"].size(), 2u);
    EXPECT_EQ(root["ray"]["fragments"][1]["depth"], 0.5);
    EXPECT_EQ(root["ray"]["warp"]["kind"], "none");
    EXPECT_EQ(root["ray"]["total_absorbance"], total_absorbance(ray));  // every digit
    EXPECT_TRUE(root["curves"].is_array() && root["curves"].empty());
}

TEST(CurveJson, OfPowerMomentsHasBounds) {
    const ordered_json curve = json_curve("power4-32");
    EXPECT_EQ(keys_of(curve), (Keys{"technique", "parameters", "moments", "depth", "true", "reconstructed",
                                    "lower", "upper"}));
    EXPECT_EQ(curve["technique"], "power4-32");
    EXPECT_EQ(keys_of(curve["parameters"]), (Keys{"beta", "alpha", "solver"}));
    EXPECT_EQ(curve["parameters"]["beta"], 0.25);
    EXPECT_EQ(curve["parameters"]["alpha"].get<float>(), 5e-7f);  // the value of `auto` here
    for (const char* key : {"depth", "true", "reconstructed", "lower", "upper"}) {
        ASSERT_EQ(curve[key].size(), 5u) << key;
        for (const ordered_json& value : curve[key]) EXPECT_TRUE(value.is_number()) << key;
    }
    EXPECT_EQ(curve["depth"], (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    EXPECT_EQ(curve["true"][1], 0.0);
    EXPECT_LT(curve["lower"][2], curve["upper"][2]);
}

TEST(CurveJson, OfTrigonometricMomentsHasBetaZeroAndOneButNoBounds) {
    const ordered_json curve = json_curve("trig3-32");
    EXPECT_EQ(keys_of(curve), (Keys{"technique", "parameters", "moments", "depth", "true", "reconstructed",
                                    "lower", "upper", "beta0", "beta1"}));
    EXPECT_EQ(keys_of(curve["parameters"]), (Keys{"beta", "theta", "alpha", "solver"}));
    EXPECT_TRUE(curve["lower"].is_null());
    EXPECT_TRUE(curve["upper"].is_null());
    ASSERT_EQ(curve["beta0"].size(), 5u);
    ASSERT_EQ(curve["beta1"].size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {  // beta = 0.25 lies between, or is clamped with both
        EXPECT_LE(curve["beta0"][i], curve["reconstructed"][i]);
        EXPECT_LE(curve["reconstructed"][i], curve["beta1"][i]);
    }
}

TEST(CurveJson, OfTheTruthHasNoMomentsBoundsOrParameters) {
    const ordered_json curve = json_curve("sorted");
    EXPECT_EQ(keys_of(curve), (Keys{"technique", "parameters", "moments", "depth", "true", "reconstructed",
                                    "lower", "upper"}));
    for (const char* key : {"moments", "lower", "upper"}) EXPECT_TRUE(curve[key].is_null()) << key;
    EXPECT_TRUE(curve["parameters"].is_object() && curve["parameters"].empty());
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(curve["true"][i].get<float>(), curve["reconstructed"][i].get<float>());
}

TEST(CurveJson, ListsPowerMomentsByTheirOrder) {
    for (const auto& [technique, count] :
         {std::pair{"power4-32", 4u}, {"power6-32", 6u}, {"power8-32", 8u}}) {
        const ordered_json moments = json_curve(technique)["moments"];
        ASSERT_EQ(moments.size(), count + 1);
        for (std::size_t k = 0; k <= count; ++k) {
            const double exact = std::log(2) * (std::pow(-0.5, k) + 2 * std::pow(0.5, k));
            EXPECT_NEAR(moments[k].get<double>(), exact, 6e-7) << k;  // absorbances are accurate to 3 ulps
        }
    }
}

TEST(CurveJson, ListsTrigonometricMomentsAsRealAndImaginaryParts) {
    for (const auto& [technique, count] : {std::pair{"trig2-32", 2u}, {"trig3-32", 3u}, {"trig4-32", 4u}}) {
        const ordered_json moments = json_curve(technique)["moments"];
        ASSERT_EQ(moments.size(), 2 * count + 1);
        EXPECT_NEAR(moments[0].get<double>(), 3 * std::log(2), 6e-7);
        for (std::size_t k = 1; k <= count; ++k) {
            const double near = static_cast<double>(k) * 0.475 * std::numbers::pi;  // theta is pi / 10
            const double re = std::log(2) * (std::cos(near) + 2 * std::cos(3 * near));
            const double im = std::log(2) * (std::sin(near) + 2 * std::sin(3 * near));
            // sincos errs by 2.1e-7; its square by twice that, its k-th power by k times that, times the
            // absorbance of 2.1.
            EXPECT_NEAR(moments[2 * k - 1].get<double>(), re, 3.6e-6) << k;
            EXPECT_NEAR(moments[2 * k].get<double>(), im, 3.6e-6) << k;
        }
    }
}

TEST(CurveJson, OfAnEmptyRayIsAllZeros) {
    for (const Technique& technique : techniques()) {
        const std::string text = curves_to_json(ViewRay(), {curve_of(ViewRay(), technique.id)});
        EXPECT_EQ(text.find("nan"), std::string::npos);
        const ordered_json curve = ordered_json::parse(text)["curves"][0];
        for (const char* key : {"true", "reconstructed"})
            for (const ordered_json& value : curve[key]) EXPECT_EQ(value, 0.0) << technique.id;
    }
}

TEST(CurveJson, KeepsTheOrderOfCurvesAndEveryDigitOfAFloat) {
    const ViewRay ray = two_fragments();
    const std::vector<Curve> curves = {curve_of(ray, "trig2-32", 33), curve_of(ray, "power8-32", 33)};
    const ordered_json rows = json_of(ray, curves)["curves"];
    ASSERT_EQ(rows.size(), 2u);
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_EQ(rows[c]["technique"], curves[c].technique->id);
        EXPECT_EQ(rows[c]["reconstructed"].get<std::vector<float>>(), curves[c].reconstructed);
        EXPECT_EQ(rows[c]["true"].get<std::vector<double>>(), curves[c].truth);
    }
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(CurveCsv, HasAHeaderAndOneRowForEachTechniqueAndDepth) {
    Curve curve;
    curve.technique = &require_technique("power4-32");
    curve.depth = {-1.0f, 0.1f};
    curve.truth = {0.0, 0.25};
    curve.reconstructed = {0.5f, 1.0f / 3.0f};
    curve.beta0 = {0.125f, 2.0f};
    curve.beta1 = {3.0f, 1e-20f};
    Curve truth = curve;
    truth.technique = &require_technique("sorted");
    truth.beta0.clear();
    truth.beta1.clear();
    EXPECT_EQ(curves_to_csv({curve, truth}),
              "technique,depth,true,reconstructed,beta0,beta1\n"
              "power4-32,-1,0,0.5,0.125,3\n"
              "power4-32,0.1,0.25,0.33333334,2,1e-20\n"
              "sorted,-1,0,0.5,,\n"
              "sorted,0.1,0.25,0.33333334,,\n");
    EXPECT_EQ(lines_of(curves_to_csv({})).size(), 1u);
}

TEST(CurveTable, NamesWhatItsColumnsAre) {
    const ViewRay ray = two_fragments();
    const auto power = lines_of(curves_to_table(ray, {curve_of(ray, "power4-32")}));
    ASSERT_EQ(power.size(), 3u + 1u + 5u);
    EXPECT_EQ(power[0], "2 fragments, total absorbance 2.07944");
    EXPECT_EQ(power[2], "power4-32");
    EXPECT_NE(power[3].find("upper"), std::string::npos);
    for (const std::string& line : lines_of(curves_to_table(ray, {curve_of(ray, "power4-32")})))
        EXPECT_EQ(line.find("beta"), std::string::npos);
    for (std::size_t i = 4; i < power.size(); ++i) EXPECT_EQ(power[i].size(), power[3].size());  // aligned
    const std::string trigonometric = curves_to_table(ray, {curve_of(ray, "trig2-32")});
    EXPECT_NE(trigonometric.find("beta = 0    beta = 1"), std::string::npos);
    EXPECT_EQ(trigonometric.find("lower"), std::string::npos);  // these are not bounds
}

TEST(EvenDepths, RunFromOneEndToTheOther) {
    EXPECT_EQ(even_depths(2), (std::vector<float>{-1, 1}));
    EXPECT_EQ(even_depths(5), (std::vector<float>{-1, -0.5f, 0, 0.5f, 1}));
    const auto many = even_depths(1'000'000);
    EXPECT_EQ(many.front(), -1.0f);
    EXPECT_EQ(many.back(), 1.0f);
    EXPECT_TRUE(std::is_sorted(many.begin(), many.end()));
}

}  // namespace
