// false_color_test.cpp -- the colours of magma, as matplotlib publishes them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/compare/false_color.hpp"

namespace momentscope {
namespace {

// Bytes of sRGB of the 256 published colours at their first, 64th, 128th and last place, as published; 17
// colours between which is interpolated may be off by a few units.
TEST(FalseColor, IsMagma) {
    const struct {
        float value;
        std::array<int, 3> srgb;
    } rows[] = {
        {0, {0, 0, 4}}, {64.0f / 255, {81, 18, 124}}, {128.0f / 255, {183, 55, 121}}, {1, {252, 253, 191}}};
    for (const auto& row : rows) {
        const Image image = false_color(std::span(&row.value, 1), 1, 1, 1);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(255 * srgb_from_linear(image.at(0, 0)[c]), row.srgb[static_cast<std::size_t>(c)], 3)
                << row.value << " channel " << c;
    }
}

TEST(FalseColor, ClampsAndSurvivesNoNumbers) {
    const float values[] = {-1, 0, 2, 1, std::numeric_limits<float>::quiet_NaN()};
    const Image image = false_color(values, 5, 1, 1);
    EXPECT_EQ(image.at(0, 0), image.at(1, 0));
    EXPECT_EQ(image.at(2, 0), image.at(3, 0));
    EXPECT_EQ(image.at(4, 0), image.at(1, 0));
}

}  // namespace
}  // namespace momentscope
