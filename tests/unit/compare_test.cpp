// compare_test.cpp -- metrics against values that were computed by hand or by another program.
#include "core/compare/difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/compare/color_spaces.hpp"
#include "core/compare/false_color.hpp"
#include "core/compare/worst_pixel.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

Image plain(int width, int height, const glm::vec3& color) {
    Image image(width, height);
    std::ranges::fill(image.pixels, glm::vec4(color, 1));
    return image;
}

TEST(Compare, EqualPicturesDifferByNothing) {
    const Image image = read_image("tests/images/wboit.png");
    for (const MetricRow& row : metrics()) EXPECT_EQ(mean_difference(image, image, row.id), 0) << row.key;
}

TEST(Compare, BlackAndWhite) {
    const Image black = plain(9, 5, glm::vec3(0)), white = plain(9, 5, glm::vec3(1));
    EXPECT_NEAR(mean_difference(black, white, Metric::rmse), 1, 1e-6);
    EXPECT_NEAR(mean_difference(black, white, Metric::delta_e), 100, 1e-3) << "L* from 0 to 100";
    const double flip = mean_difference(black, white, Metric::flip);
    EXPECT_GT(flip, 0.95);
    EXPECT_LE(flip, 1);
}

// L*a*b* of the primaries under D65, from published tables.
TEST(Compare, LabOfPrimaries) {
    const auto expect = [](const glm::dvec3& rgb, const glm::dvec3& lab) {
        EXPECT_LT(glm::distance(lab_of_linear(rgb), lab), 0.03);
    };
    expect({1, 0, 0}, {53.24, 80.09, 67.20});
    expect({0, 1, 0}, {87.73, -86.18, 83.18});
    expect({0, 0, 1}, {32.30, 79.19, -107.86});
    const glm::dvec3 color(0.2, 0.5, 0.9);
    EXPECT_LT(glm::distance(linear_of_opponent(opponent_of_linear(color)), color), 1e-12);
}

// Root mean square: one pixel of twelve is off by 1 in one of three channels.
TEST(Compare, OnePixel) {
    const Image a = plain(4, 3, glm::vec3(0.5f));
    Image b = a;
    b.at(1, 1).g += 1;
    EXPECT_NEAR(mean_difference(a, b, Metric::rmse), 1.0 / 6, 1e-6);
}

// An independent program, which convolves with full two-dimensional kernels and uses the matrix of the
// published code, gives 0.0774147.
TEST(Compare, FlipOfACommittedPair) {
    const Image sorted = read_image("tests/images/sorted.png"), wboit = read_image("tests/images/wboit.png");
    EXPECT_NEAR(mean_difference(sorted, wboit, Metric::flip), 0.0774147, 5e-6);
    EXPECT_EQ(mean_difference(wboit, sorted, Metric::flip), mean_difference(sorted, wboit, Metric::flip));
}

TEST(Compare, StoppedWorkHasNoResult) {
    std::stop_source stop;
    stop.request_stop();
    const Image image = plain(9, 5, glm::vec3(0.5f));
    for (const MetricRow& row : metrics())
        EXPECT_TRUE(difference_map(image, image, row.id, stop.get_token()).empty()) << row.key;
}

TEST(Compare, PartsOfMaps) {
    const std::vector<float> map = {0, 1, 2, 10, 11, 12};
    EXPECT_EQ(part_of(map, 3, {1, 0, 2, 2}), (std::vector<float>{1, 2, 11, 12}));
    EXPECT_EQ(part_of(map, 3, {0, 1, 1, 1}), std::vector<float>{10});
}

TEST(WorstPixel, KeepsItsDistanceAndStaysWithinTheRegion) {
    constexpr int WIDTH = 64;
    std::vector<float> map(WIDTH * 40, 0.0f);
    map[10 * WIDTH + 20] = 5;
    map[10 * WIDTH + 35] = 4;  // 15 pixels away
    map[10 * WIDTH + 36] = 3;  // 16 pixels away
    map[39 * WIDTH + 63] = 2;
    const PixelRegion all = {0, 0, WIDTH, 40};
    std::vector<glm::ivec2> visited;
    for (const glm::ivec2 next : {glm::ivec2(20, 10), glm::ivec2(36, 10), glm::ivec2(63, 39)}) {
        EXPECT_EQ(next_worst_pixel(map, WIDTH, all, visited), next);
        visited.push_back(next);
    }
    EXPECT_EQ(next_worst_pixel(map, WIDTH, all, visited), std::nullopt);
    EXPECT_EQ(next_worst_pixel(map, WIDTH, {36, 10, 28, 30}, {}), glm::ivec2(36, 10));
    EXPECT_EQ(next_worst_pixel(map, WIDTH, {0, 0, 20, 40}, {}), std::nullopt) << "nothing differs there";
}

TEST(Compare, FalseColorsGoFromBlackToBright) {
    const float values[] = {0, 0.5f, 1, 7};
    const Image image = false_color(values, 4, 1, 1);
    EXPECT_LT(glm::length(glm::vec3(image.at(0, 0))), 0.02f);
    EXPECT_GT(image.at(1, 0).r, image.at(0, 0).r);
    EXPECT_GT(image.at(2, 0).g, image.at(1, 0).g);
    EXPECT_EQ(image.at(3, 0), image.at(2, 0)) << "what is beyond the scale has its end's colour";
}

// Straight alpha is stored separately from the colours: half of the red must not be lost.
TEST(ReadImage, KeepsColoursAndAlphaAsTheyAreStored) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / "momentscope_straight_alpha.png";
    write_png({255, 0, 0, 128, 0, 0, 255, 255}, 2, 1, path);
    const Image image = read_image(path);
    EXPECT_EQ(image.at(0, 0).r, 1.0f);
    EXPECT_NEAR(image.at(0, 0).a, 128.0f / 255, 1e-6f);
    EXPECT_EQ(image.at(1, 0), glm::vec4(0, 0, 1, 1));
    std::filesystem::remove(path);
}

TEST(ReadImage, GivesBackWhatWasWritten) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "momentscope_read_image";
    std::filesystem::create_directories(folder);
    Image image = plain(3, 2, {0.25f, 0.5f, 2});
    write_image(image, folder / "a.exr");
    EXPECT_EQ(read_image(folder / "a.exr").pixels, image.pixels);
    write_image(image, folder / "a.png");
    const Image rounded = read_image(folder / "a.png");
    EXPECT_NEAR(rounded.at(1, 1).g, 0.5f, 4e-3f) << "half of 1/255 in sRGB";
    EXPECT_EQ(rounded.at(1, 1).b, 1.0f) << "clamped";
    std::ofstream(folder / "broken.png") << "no picture";
    expect_error([&] { read_image(folder / "broken.png"); }, "cannot be read (");
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace momentscope::test
