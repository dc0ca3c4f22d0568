// random_methods_test.cpp -- stochastic transparency and hashed alpha testing: their results with given
// random numbers, and on average.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/support/glsl.hpp"
#include "tests/property/pixel_state_support.hpp"

namespace momentscope::glsl::threshold_parts {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// portable_math first, because the other uses it
#include "shaders/shared/alpha_threshold.glsl"
#pragma GCC diagnostic pop
}  // namespace momentscope::glsl::threshold_parts

namespace momentscope::test {
namespace {

constexpr int FOLLOWED_RAYS = 300;

TEST(Stochastic, CountsTheSamplesThatSeeADepth) {
    const Technique& technique = require_technique("stochastic");
    RandomNumbers random(27);
    for (int i = 0; i < FOLLOWED_RAYS; ++i) {
        const ViewRay ray = reseeded(random_ray(random, 1 + i % 12), static_cast<std::uint32_t>(i));
        const int samples = 1 + i % 64;
        const ParameterValues values = values_with({{ParameterId::samples, static_cast<float>(samples)},
                                                    {ParameterId::renormalize, i % 2 == 0 ? 1.0f : 0.0f}});
        std::vector<double> nearest(static_cast<std::size_t>(samples), 9);
        for (const Fragment& f : ray.fragments)
            for (int s = 0; s < samples; ++s)
                if (unit_random(f.seed, s) < f.opacity)
                    nearest[static_cast<std::size_t>(s)] =
                        std::min(nearest[static_cast<std::size_t>(s)], static_cast<double>(f.depth));
        const auto own = own_transmittance(ray, technique, resolve(values, technique).settings);
        for (std::size_t k = 0; k < own.size(); ++k) {
            const auto seeing = std::ranges::count_if(
                nearest, [&](double z) { return z >= static_cast<double>(ray.fragments[k].depth); });
            EXPECT_NEAR(static_cast<double>(own[k]), static_cast<double>(seeing) / samples, 1e-6);
        }
        const double empty = static_cast<double>(std::ranges::count(nearest, 9.0)) / samples;
        EXPECT_NEAR(color_of(ray, technique, values).a, i % 2 == 0 ? std::exp(-total_absorbance(ray)) : empty,
                    1e-6);
    }
}

// The result is unbiased, and the error falls with the square root of the number of samples.
TEST(Stochastic, ConvergesWithTheRootOfTheSamples) {
    const Technique& technique = require_technique("stochastic");
    RandomNumbers random(28);
    constexpr int RUNS = 4000;
    for (const int samples : {1, 4, 16, 64}) {
        const ParameterValues values = values_with({{ParameterId::samples, static_cast<float>(samples)}});
        double squares = 0, sum = 0, expected_squares = 0;
        for (int run = 0; run < RUNS; ++run) {
            const ViewRay ray =
                reseeded(random_ray(random, 6), static_cast<std::uint32_t>(run * 64 + samples));
            const std::vector<float> depth = {0.25f};
            const double truth = std::exp(-true_absorbance(ray, depth)[0]);
            const double t = static_cast<double>(
                pixel_state_transmittance(ray, technique, resolve(values, technique).settings, depth)[0]);
            sum += t - truth;
            squares += (t - truth) * (t - truth);
            expected_squares += truth * (1 - truth) / samples;  // of a binomial distribution
        }
        EXPECT_NEAR(squares / expected_squares, 1, 0.12) << samples;  // 5 sigma of 4000 squares
        EXPECT_NEAR(sum / RUNS, 0, 5 * std::sqrt(expected_squares) / RUNS) << samples;
    }
}

TEST(Hashed, ShowsTheNearestOfThoseThatReachTheirThreshold) {
    const Technique& technique = require_technique("hashed");
    RandomNumbers random(29);
    glm::dvec4 sum(0), expected(0);
    constexpr int RUNS = 40'000;
    for (int run = 0; run < RUNS; ++run) {
        const ViewRay ray = reseeded(colored_ray(random, 1 + run % 5), static_cast<std::uint32_t>(run));
        glm::dvec4 nearest(0, 0, 0, 1);
        for (const std::size_t i : front_to_back(ray)) {
            const Fragment& f = ray.fragments[i];
            if (nearest.a > 0 && f.opacity >= f.threshold) nearest = glm::dvec4(glm::dvec3(f.color), 0);
        }
        const glm::dvec4 color = color_of(ray, technique, {});
        expect_near(color, nearest, 0);
        sum += color;
        expected += true_color(ray);
    }
    expect_near(sum / static_cast<double>(RUNS), expected / static_cast<double>(RUNS),
                0.01);  // correct on average
}

// Kolmogorov and Smirnov: 100,000 uniform numbers stay within 0.0061 of their distribution with 99.9 %
// probability. Places on a grid are less random than that.
TEST(Hashed, ThresholdsAreUniform) {
    RandomNumbers random(30);
    for (const float width : {0.9f, 0.013f, 0.0031f}) {
        std::vector<double> thresholds;
        for (int i = 0; i < 100'000; ++i)
            thresholds.push_back(static_cast<double>(glsl::threshold_parts::alpha_threshold(
                random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30), width)));
        std::ranges::sort(thresholds);
        double worst = 0;
        for (std::size_t i = 0; i < thresholds.size(); ++i)
            worst = std::max(worst, std::abs(thresholds[i] - static_cast<double>(i) / 100'000));
        EXPECT_LT(worst, 0.01) << width;
    }
}

}  // namespace
}  // namespace momentscope::test
