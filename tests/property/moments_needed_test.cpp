// moments_needed_test.cpp -- the certificate is right where theory gives its value, and no error exceeds it.
#include "core/inspect/moments_needed.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/property/random_rays.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

ViewRay sheets(int count) {
    ViewRay ray;
    for (int i = 0; i < count; ++i)
        ray.fragments.push_back({.depth = -0.8f + 0.4f * static_cast<float>(i), .opacity = 0.5f});
    return ray;
}

// n <= m/2 + 1 surfaces are exact at their own depths (Section 4.1): up to three surfaces need four moments,
// four need six, five need eight.
TEST(MomentsNeeded, OfSheetsAreWhatTheorySays) {
    constexpr std::array WANTED = {Needed::four, Needed::four, Needed::four, Needed::six, Needed::eight};
    for (const char* basis : {"power", "chebyshev"})
        for (int count = 1; count <= 5; ++count) {
            SCOPED_TRACE(fmt::format("{} sheets, {}", count, basis));
            const PixelNeed need = pixel_need(sheets(count), moment_orders(basis), {});
            EXPECT_EQ(need.by_certificate, WANTED[static_cast<std::size_t>(count - 1)]);
            EXPECT_LE(need.by_error, need.by_certificate);
        }
    EXPECT_EQ(pixel_need(sheets(0), moment_orders("power"), {}), PixelNeed());
    EXPECT_EQ(pixel_need(sheets(8), moment_orders("power"), {}).by_certificate, Needed::more);
}

// The truth and the result both lie between the bounds, so they differ by at most the gap. The bounds are
// those of the biased moments. Chebyshev moments have the least bias; the test allows ten times the measured
// effect of this bias.
TEST(MomentsNeeded, NoErrorExceedsTheCertificate) {
    const MomentOrders orders = moment_orders("chebyshev");
    double worst = 0;
    int above = 0;
    std::mt19937 random(11);
    for (int i = 0; i < 5000; ++i) {
        const ViewRay ray = random_ray(random);
        for (const Technique* order : orders) {
            const double gap = certified_gap(ray, *order, {});
            ASSERT_GE(gap, 0.0);
            ASSERT_LE(gap, 1.0);
            const double excess = greatest_error(ray, *order, {}) - gap;
            worst = std::max(worst, excess);
            above += excess > 1e-4 ? 1 : 0;
        }
    }
    fmt::print("errors exceed the certificate by at most {:.2e}\n", worst);
    // If surfaces nearly tie twice, floats do not distinguish their nodes. In 200,000 rays and three orders
    // this happens once or twice.
    EXPECT_LE(above, 1);
    EXPECT_LE(worst, 1e-3);
}

TEST(MomentsNeeded, MoreMomentsAreNeverLessCertainWithoutBias) {
    ParameterValues values;
    values.set(ParameterId::alpha, 1e-7f);
    const MomentOrders orders = moment_orders("chebyshev");
    std::mt19937 random(12);
    for (int i = 0; i < 2000; ++i) {
        const ViewRay ray = random_ray(random);
        const double of_4 = certified_gap(ray, *orders[0], values);
        const double of_8 = certified_gap(ray, *orders[2], values);
        // The greatest T falls as the lower bound rises, so gaps fall except for rounding.
        EXPECT_LE(of_8, of_4 + 1e-4) << i;
    }
}

TEST(MomentsNeeded, CountsEveryPixelOnce) {
    const std::vector<PixelNeed> pixels = {
        {}, {Needed::four, Needed::six}, {Needed::eight, Needed::four}, {Needed::more, Needed::more}};
    const NeedHistogram histogram = count_needs(pixels);
    EXPECT_EQ(histogram.by_certificate, (std::array<long, NEEDED_COUNT>{1, 1, 0, 1, 1}));
    EXPECT_EQ(histogram.by_error, (std::array<long, NEEDED_COUNT>{1, 1, 1, 0, 1}));
    EXPECT_EQ(histogram.cautious, 1);
    EXPECT_EQ(histogram.overlooked, 1);
}

TEST(MomentsNeeded, ATileStoresTheMostThatOneOfItsPixelsNeeds) {
    std::vector<PixelNeed> pixels(6 * 4);  // two tiles of 4x4; the right one is cut off
    EXPECT_EQ(tiled_memory(pixels, 6, 4), 0.0);
    pixels[0].by_certificate = Needed::four;
    pixels[7].by_certificate = Needed::six;
    EXPECT_DOUBLE_EQ(tiled_memory(pixels, 6, 4), 16 * 7 / (9.0 * 24));
    pixels[1].by_certificate = Needed::eight;
    EXPECT_DOUBLE_EQ(tiled_memory(pixels, 6, 4), 16 * 9 / (9.0 * 24));
    pixels[1].by_certificate = Needed::nothing;
    pixels[5].by_certificate = Needed::more;
    EXPECT_DOUBLE_EQ(tiled_memory(pixels, 6, 4), (16 * 7 + 8 * 9) / (9.0 * 24));
}

TEST(MomentsNeeded, RefusesBasesWithoutBounds) {
    expect_error([] { moment_orders("trigonometric"); }, "power or chebyshev");
}

}  // namespace
}  // namespace momentscope::test
