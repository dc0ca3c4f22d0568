// ray_json_test.cpp -- view rays to JSON and back, and which sentence refuses wrong ones.
#include "core/ray/ray_json.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

using namespace momentscope;

namespace {

namespace fs = std::filesystem;

std::string with_fragments(const std::string& entries, const std::string& rest = "") {
    return R"({"fragments": [)" + entries + "]" + rest + "}";
}

std::string with_warp(const std::string& warp) {
    return with_fragments(R"({"depth": 2, "opacity": 0.5})", R"(, "warp": )" + warp);
}

void expect_refused(const std::string& text, const std::string& part) {
    SCOPED_TRACE(text.substr(0, 100));
    expect_error([&] { ray_from_json(text); }, part);
}

Fragment fragment_at(float depth, float opacity, glm::vec3 color) {
    Fragment fragment;
    fragment.depth = fragment.view_depth = depth;
    fragment.opacity = opacity;
    fragment.color = color;
    return fragment;
}

/// Equal in every bit: JSON has enough digits.
void expect_same(const ViewRay& a, const ViewRay& b) {
    ASSERT_EQ(a.fragments.size(), b.fragments.size());
    for (std::size_t i = 0; i < a.fragments.size(); ++i) {
        EXPECT_EQ(a.fragments[i].depth, b.fragments[i].depth) << i;
        EXPECT_EQ(a.fragments[i].view_depth, b.fragments[i].view_depth) << i;
        EXPECT_EQ(a.fragments[i].opacity, b.fragments[i].opacity) << i;
        EXPECT_EQ(a.fragments[i].color, b.fragments[i].color) << i;
    }
    EXPECT_EQ(a.warp.kind, b.warp.kind);
    EXPECT_EQ(a.warp.z_min, b.warp.z_min);
    EXPECT_EQ(a.warp.z_max, b.warp.z_max);
    EXPECT_EQ(a.near_plane, b.near_plane);
    EXPECT_EQ(a.far_plane, b.far_plane);
}

TEST(RayJson, ComesBackTheSameWithoutAWarp) {
    ViewRay ray;  // in submission order, not in order of depth
    ray.fragments = {fragment_at(0.1f, 1.0f / 3.0f, {0.1f, 0.7f, 1e-8f}),
                     fragment_at(-1.0f, 0.0f, {0, 1, 65504.0f}), fragment_at(1.0f, 1.0f, {1, 1, 1}),
                     fragment_at(-1e-20f, 1.0f / 255.0f, {0.5f, 0, 0})};
    expect_same(ray_from_json(ray_to_json(ray).dump()), ray);
}

TEST(RayJson, ComesBackTheSameWithALogarithmicWarp) {
    ViewRay ray;
    ray.warp = {DepthWarp::Kind::logarithmic, 0.1f, 123.4f};
    ray.near_plane = 0.05f;
    ray.far_plane = 1000.0f;
    for (const float view_depth : {0.1f, 7.7f, 123.4f, 0.2f}) {
        ray.fragments.push_back(fragment_at(view_depth, 0.3f, {0.2f, 0.4f, 0.8f}));
        ray.fragments.back().depth = to_depth(view_depth, ray.warp);
    }
    const auto root = ray_to_json(ray);
    EXPECT_EQ(root["warp"]["kind"], "log");
    EXPECT_EQ(root["fragments"][1]["depth"], 7.7f);  // linear, not warped
    expect_same(ray_from_json(root.dump()), ray);
}

TEST(RayJson, ComesBackTheSameWithTheLinearWarpOfALight) {
    ViewRay ray;
    ray.warp = {DepthWarp::Kind::linear, 6.0f, 14.0f};
    for (const float view_depth : {6.0f, 8.0f, 14.0f}) {
        ray.fragments.push_back(fragment_at(view_depth, 0.3f, {0.2f, 0.4f, 0.8f}));
        ray.fragments.back().depth = to_depth(view_depth, ray.warp);
    }
    EXPECT_EQ(ray.fragments[1].depth, -0.5f);
    EXPECT_EQ(to_view_depth(-0.5f, ray.warp), 8.0f);
    const auto root = ray_to_json(ray);
    EXPECT_EQ(root["warp"]["kind"], "linear");
    expect_same(ray_from_json(root.dump()), ray);
}

TEST(RayJson, NumbersFragmentsByTheirOrderAndFillsInWhatIsOptional) {
    const ViewRay ray =
        ray_from_json(with_fragments(R"({"depth": 0.5, "opacity": 1}, {"depth": -0.5, "opacity": 0})"));
    ASSERT_EQ(ray.fragments.size(), 2u);
    EXPECT_EQ(ray.fragments[0].draw, 0u);
    EXPECT_EQ(ray.fragments[1].draw, 1u);
    EXPECT_EQ(ray.fragments[1].depth, -0.5f);
    EXPECT_EQ(ray.fragments[1].view_depth, -0.5f);
    EXPECT_EQ(ray.fragments[0].color, glm::vec3(1));
    EXPECT_FALSE(ray.warp.has_view_depths());
    EXPECT_EQ(ray.near_plane, 0.0f);
    EXPECT_TRUE(ray_from_json(with_fragments("")).fragments.empty());
    EXPECT_FALSE(ray_from_json(with_fragments("", R"(, "warp": null)")).warp.has_view_depths());
    EXPECT_FALSE(ray_from_json(with_fragments("", R"(, "warp": {"kind": "none"})")).warp.has_view_depths());
}

TEST(RayJson, KeepsSeedsThresholdsAndShares) {
    ViewRay ray =
        ray_from_json(R"({"fragments": [{"depth": 0.1, "opacity": 0.5, "seed": 4294967295, "threshold": 0.25},
                                                  {"depth": 0.2, "opacity": 0.5}]})");
    EXPECT_EQ(ray.fragments[0].seed, 4294967295U);
    EXPECT_EQ(ray.fragments[0].threshold, 0.25f);
    EXPECT_NE(ray.fragments[0].seed, ray.fragments[1].seed);
    EXPECT_EQ(ray.fragments[1].threshold, unit_random(ray.fragments[1].seed, 0));
    ray.low_resolution_sources = {{0.75f, ray.fragments}, {0.25f, {}}};
    EXPECT_EQ(ray_from_json(ray_to_json(ray).dump()), ray);
}

TEST(RayJson, RefusesWrongSeedsAndShares) {
    for (const char* seed : {"-1", "4294967296", "0.5", "\"a\""})
        expect_refused(with_fragments(std::string(R"({"depth": 0, "opacity": 1, "seed": )") + seed + "}"),
                       "\"seed\"");
    for (const char* shares : {"1", "[1]", "[{}]", R"([{"weight": 1}])"})
        expect_refused(with_fragments("", std::string(R"(, "shares": )") + shares), "\"shares\" must be");
    expect_refused(with_fragments("", R"(, "shares": [{"fragments": []}])"), "\"weight\"");
    expect_refused(with_fragments("", R"(, "shares": [{"weight": 2, "fragments": []}])"), "weight 2");
    expect_refused(
        with_fragments("", R"(, "shares": [{"weight": 1, "fragments": [{"depth": 3, "opacity": 1}]}])"),
        "depth 3");
}

TEST(RayJson, RefusesWhatIsNoJson) {
    expect_refused(with_fragments(R"({"depth": 0, "opacity": 0.5, "alpha": 3})"), "\"alpha\"");
    expect_refused(with_fragments("", R"(, "typo": 1)"), "\"typo\"");
    expect_refused(with_fragments("", R"(, "warp": {"kind": "none", "z_min": 1})"), "\"z_min\"");
    expect_refused(with_fragments("", R"(, "shares": [{"weight": 1, "fragments": [], "x": 1}])"), "\"x\"");
    expect_refused(with_fragments(R"({"depth": 0, "opacity": [0.1, 0.5, 0.9]})"), "one number");
    expect_refused(with_fragments(R"({"depth": 0, "opacity": 0.5, "threshold": 2})"), "threshold 2");
    expect_refused(with_fragments("", R"(, "warp": {"kind": "log", "z_min": 0, "z_max": 10})"), "above 0");
    expect_refused(with_fragments("", R"(, "near": 1)"), "far");
    expect_refused(with_fragments("", R"(, "near": 1, "far": 1)"), "far");
    for (const char* text : {"", "{", "nonsense", R"({"fragments": [}])", "{'fragments': []}",
                             R"({"fragments": []} x)", R"({"fragments": [],})", "\xff\xfe", "{\"\xc3\": 1}"})
        expect_refused(text, "not valid JSON at byte");
    expect_refused(std::string(1000, '\0'), "not valid JSON");
    for (const char* token : {"NaN", "Infinity", "-Infinity", "nan", "+1", "01", ".5"})
        expect_refused(with_fragments(std::string(R"({"opacity": 0.5, "depth": )") + token + "}"),
                       "not valid JSON");
}

TEST(RayJson, RefusesNestingWithoutFollowingIt) {
    expect_refused(std::string(100'000, '['), "nested too deeply");
    expect_refused(with_fragments(std::string(100'000, '[')), "nested too deeply");
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    expect_refused(objects, "nested too deeply");
}

TEST(RayJson, RefusesNumbersBeyondAFloat) {
    for (const char* key : {"depth", "opacity"})
        for (const char* value : {"1e999", "-1e999", "1e39", "-1e300"}) {
            const std::string other = key == std::string("depth") ? R"("opacity": 1)" : R"("depth": 0)";
            expect_refused(with_fragments(std::string("{\"") + key + "\": " + value + ", " + other + "}"),
                           "finite number");
        }
    expect_refused(with_fragments("", R"(, "far": 1e300)"), "far");
    expect_refused(with_fragments(R"({"depth": 0, "opacity": 0, "color": [1e999, 0, 0]})"), "finite number");
}

TEST(RayJson, RefusesMissingKeysAndWrongTypes) {
    for (const char* text : {"[]", "{}", "1", "null", "\"fragments\"", R"({"fragments": 1})",
                             R"({"fragments": {}})", R"({"fragments": null})", R"({"Fragments": []})"})
        expect_refused(text, "list \"fragments\"");
    for (const char* entry : {"1", "[]", "null", "\"depth\""})
        expect_refused(with_fragments(entry), "fragment 0 must be");
    expect_refused(with_fragments(R"({"opacity": 1})"), "fragment 0 needs a number \"depth\"");
    expect_refused(with_fragments(R"({"depth": 0, "opacity": 1}, {"depth": 0})"),
                   "fragment 1 needs a number \"opacity\"");
    expect_refused(with_fragments(R"({"depth": "0", "opacity": 1})"), "\"depth\"");
    expect_refused(with_fragments(R"({"depth": true, "opacity": 1})"), "\"depth\"");
    expect_refused(with_fragments(R"({"depth": 0, "opacity": null})"), "\"opacity\"");
    expect_refused(with_fragments("", R"(, "near": "0")"), "\"near\"");
}

TEST(RayJson, RefusesOpacitiesDepthsAndColorsOutsideTheirRanges) {
    for (const char* opacity : {"-0.001", "1.001", "2", "-1e30"})
        expect_refused(with_fragments(std::string(R"({"depth": 0, "opacity": )") + opacity + "}"),
                       "from 0 to 1");
    for (const char* depth : {"-1.001", "1.001", "1e30"})
        expect_refused(with_fragments(std::string(R"({"opacity": 0, "depth": )") + depth + "}"),
                       "from -1 to 1");
    for (const char* color : {"[0, 0]", "[0, 0, 0, 0]", "[0, 0, -1]", "[0, 0, 65505]", "1", "null",
                              "[0, 0, null]", R"("red")", R"({"r": 0, "g": 0, "b": 0})"})
        expect_refused(with_fragments(std::string(R"({"depth": 0, "opacity": 0, "color": )") + color + "}"),
                       "\"color\"");
}

TEST(RayJson, RefusesWrongWarps) {
    for (const char* warp : {"1", "[]", "\"log\"", "{}", R"({"kind": 1})", R"({"z_min": 1, "z_max": 3})"})
        expect_refused(with_warp(warp), "\"kind\"");
    for (const char* kind : {"cubic", "LOG", ""})
        expect_refused(with_warp(std::string("{\"kind\": \"") + kind + "\", \"z_min\": 1, \"z_max\": 3}"),
                       "warp kind");
    expect_refused(with_warp(R"({"kind": "log"})"), "\"z_min\"");
    expect_refused(with_warp(R"({"kind": "log", "z_min": 1})"), "\"z_max\"");
    for (const char* range :
         {"0, \"z_max\": 3", "-1, \"z_max\": 3", "1e-31, \"z_max\": 3", "3, \"z_max\": 1", "2, \"z_max\": 2"})
        expect_refused(with_warp(std::string(R"({"kind": "log", "z_min": )") + range + "}"), "z_min above 0");
    for (const char* range : {"2.5, \"z_max\": 3", "1, \"z_max\": 1.5"})  // the fragment at 2 lies outside
        expect_refused(with_warp(std::string(R"({"kind": "log", "z_min": )") + range + "}"),
                       "fragment 0 has depth 2");
}

TEST(RayJson, ALineBreakInAWarpKindStaysOnOneLine) {
    expect_refused(with_warp(R"({"kind": "a\nb", "z_min": 1, "z_max": 3})"), "warp kind");
}

TEST(RayJson, AWarpTooNarrowForFloatsIsRefusedOrHarmless) {
    // ln z_max - ln z_min rounds to 0 although z_min < z_max: 1 ulp of 1000 against 1 ulp of ln 1000.
    const std::string text =
        with_fragments(R"({"depth": 1000, "opacity": 0.5})",
                       R"(, "warp": {"kind": "log", "z_min": 1000, "z_max": 1000.0001})");
    try {
        const ViewRay ray = ray_from_json(text);
        EXPECT_GE(ray.fragments[0].depth, -1.0f);  // false for NaN
        EXPECT_LE(ray.fragments[0].depth, 1.0f);
    } catch (const Error& error) {
        expect_one_sentence(error.what());
    }
}

std::string with_count(std::size_t count) {
    std::string entries = R"({"depth":0,"opacity":0})";
    for (std::size_t i = 1; i < count; ++i) entries += R"(,{"depth":0,"opacity":0})";
    return with_fragments(entries);
}

TEST(RayJson, ReadsAsManyFragmentsAsItSaysAndNoMore) {
    EXPECT_EQ(ray_from_json(with_count(MAX_RAY_FRAGMENTS)).fragments.size(), MAX_RAY_FRAGMENTS);
    expect_refused(with_count(MAX_RAY_FRAGMENTS + 1), "100001 fragments; at most 100000");
    expect_refused(std::string(MAX_RAY_FILE_BYTES + 1, ' '), "larger than 64 MiB");
}

// Twenty million empty values of 3 bytes each would take 1 GiB and more.
TEST(RayJson, RefusesMoreValuesThanMemoryBears) {
    std::string values = "{}";
    for (int i = 0; i < 1'000'000; ++i) values += ",{}";
    expect_refused(with_fragments(values), "more than 2000000 values");
}

TEST(RayFile, IsReadAndWhatIsNoneIsRefused) {
    const fs::path folder = fs::temp_directory_path() / ("momentscope_ray_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const fs::path good = folder / "good.json";
    std::ofstream(good) << with_fragments(R"({"depth": 0.25, "opacity": 0.5})");
    EXPECT_EQ(read_ray_file(good).fragments.at(0).depth, 0.25f);
    expect_error([&] { read_ray_file(folder); }, folder.string());
    expect_error([&] { read_ray_file(folder / "missing.json"); }, "missing.json");
    expect_error([&] { read_ray_file(""); }, "no view ray file");
    expect_error([] { read_ray_file("/dev/zero"); }, "no view ray file");  // endless
    const fs::path large = folder / "large.json";
    std::ofstream(large) << "";
    fs::resize_file(large, MAX_RAY_FILE_BYTES + 1);  // a hole, so it takes no disk space
    expect_error([&] { read_ray_file(large); }, "larger than 64 MiB");
    fs::remove_all(folder);
}

}  // namespace
