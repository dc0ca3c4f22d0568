// uncertainty_test.cpp -- what the bounds leave open of a pixel's colour.
#include <gtest/gtest.h>

#include "core/inspect/color_uncertainty.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope {
namespace {

PixelCapture capture_of(const std::vector<std::pair<float, float>>& depths_and_opacities) {
    PixelCapture capture;
    for (const auto& [depth, opacity] : depths_and_opacities)
        capture.ray.fragments.push_back(plain_fragment(depth, opacity, capture.ray.fragments.size()));
    return capture;
}

TEST(ColorUncertainty, IsNothingWhereMomentsDetermineTheRay) {
    const ColorUncertainty two =
        color_uncertainty(capture_of({{-0.4f, 0.5f}, {0.3f, 0.5f}}), parse_configuration("sharp4"));
    EXPECT_TRUE(two.covered);
    EXPECT_LT(two.open, 1e-3f);
    EXPECT_LT(two.error, 1e-3f);
    EXPECT_FALSE(color_uncertainty({}, parse_configuration("sharp4")).covered);
}

// Without renormalisation the error is at most what the bounds leave open, but for bias and rounding.
TEST(ColorUncertainty, BoundsTheError) {
    RandomNumbers random(4);
    for (const char* text : {"certain4:alpha=1e-7", "cheb4-32:estimate=own-beta,renormalize=off",
                             "cheb6-32:estimate=expected,ends=known,interval=pixel,renormalize=off"}) {
        const Configuration configuration = parse_configuration(text);
        const bool moved = resolve(configuration.values, *configuration.technique).renormalizes();
        double open = 0;
        for (int i = 0; i < 200; ++i) {
            PixelCapture capture;
            capture.ray = random_ray(random, 3 + i % 8);
            const ColorUncertainty pixel = color_uncertainty(capture, configuration);
            if (!moved) {
                EXPECT_LE(pixel.error, pixel.open + 1e-3f) << text << ", ray " << i;
            }
            open += static_cast<double>(pixel.open);
        }
        EXPECT_GT(open, 1) << text;
    }
}

TEST(ColorUncertainty, SaysWhatItCounted) {
    const std::vector<ColorUncertainty> pixels = {{true, 0.2f, 0.1f}, {true, 0.4f, 0.2f}, {}};
    const std::string text = uncertainty_text(pixels);
    EXPECT_NE(text.find("mean of 2 pixels  0.30000"), std::string::npos) << text;
    EXPECT_NE(text.find("1.00"), std::string::npos) << "the two are proportional";
    EXPECT_EQ(uncertainty_text({}), "No pixel has a fragment.\n");
}

}  // namespace
}  // namespace momentscope
