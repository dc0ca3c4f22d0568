// methods_test.cpp -- techniques without moments against their definitions, written down a second time in
// double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/glsl.hpp"
#include "core/inspect/curve.hpp"
#include "core/inspect/exact.hpp"
#include "core/inspect/method_pixel.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope::glsl::method_parts {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// portable_math first: the others build on it
#include "shaders/shared/alpha_threshold.glsl"
#include "shaders/shared/rounding.glsl"
// and this on rounding
#include "shaders/shared/nonlinear_quantisation.glsl"
#pragma GCC diagnostic pop
}  // namespace momentscope::glsl::method_parts

namespace momentscope::test {
namespace {

namespace parts = glsl::method_parts;

constexpr int RAYS = 300;

ParameterValues values_of(std::initializer_list<std::pair<ParameterId, float>> settings) {
    ParameterValues values;
    for (const auto& [id, value] : settings) values.set(id, value);
    return values;
}

// In [0, 1] of the depth range, in double.
double unit_depth(float depth) {
    return 0.5 * (static_cast<double>(depth) + 1);
}

double opacity_of(const Fragment& fragment) {
    return static_cast<double>(fragment.opacity);
}

double absorbance_of(const Fragment& fragment) {
    return -std::log1p(-opacity_of(fragment));
}

ViewRay colored_ray(RandomNumbers& random, int count) {
    ViewRay ray = random_ray(random, count);
    for (Fragment& fragment : ray.fragments)
        fragment.color = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    return ray;
}

// Composited front to back.
glm::dvec4 true_color(const ViewRay& ray) {
    glm::dvec4 result(0, 0, 0, 1);
    for (const std::size_t i : front_to_back(ray)) {
        const Fragment& f = ray.fragments[i];
        result += glm::dvec4(glm::dvec3(f.color) * (result.a * opacity_of(f)), -result.a * opacity_of(f));
    }
    return result;
}

glm::dvec4 color_of(const ViewRay& ray, const Technique& technique, const ParameterValues& values) {
    const MethodSettings settings = technique.method_settings(values);
    const Composited all = technique.method->composited(pixel_state(ray, technique, settings), settings);
    return {all.red, all.green, all.blue, all.transmittance};
}

void expect_near(const glm::dvec4& a, const glm::dvec4& b, double tolerance) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

double fourier_absorbance(const ViewRay& ray, int frequencies, bool lanczos, double depth) {
    constexpr double PI = std::numbers::pi;
    double sum = 0;
    for (const Fragment& fragment : ray.fragments) {
        const double at = unit_depth(fragment.depth);
        double wave = depth;  // 2 A_l times half the depth
        for (int k = 1; k <= frequencies; ++k) {
            const double x = PI * k / (frequencies + 1);
            const double damping = lanczos ? std::sin(x) / x : 1;
            // The integral of 2 cos(2 pi k (s - d_l)) from 0 to depth.
            wave += damping * (std::sin(2 * PI * k * (depth - at)) + std::sin(2 * PI * k * at)) / (PI * k);
        }
        sum += absorbance_of(fragment) * wave;
    }
    return sum;
}

TEST(Fourier, IsTheTruncatedSeriesOfTheFragments) {
    const Technique& technique = require_technique("fourier");
    RandomNumbers random(21);
    int ringing = 0;
    for (int i = 0; i < RAYS; ++i) {
        const ViewRay ray = random_ray(random, 1 + i % 12);
        const bool many = i % 2 == 1, lanczos = i % 4 > 1;
        const ParameterValues values = values_of(
            {{ParameterId::coefficients, many ? 1.0f : 0.0f}, {ParameterId::lanczos, lanczos ? 1.0f : 0.0f}});
        const std::vector<float> depths = even_depths(33);
        const auto t = method_transmittance(ray, technique, technique.method_settings(values), depths);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            const double exact = fourier_absorbance(ray, many ? 7 : 3, lanczos, unit_depth(depths[d]));
            // A of up to 36 in floats; T cannot be off by more than its relative error.
            EXPECT_NEAR(static_cast<double>(t[d]), std::exp(-std::max(exact, 0.0)), 2e-5);
            if (d > 0) ringing += t[d] > t[d - 1] * 1.0001f ? 1 : 0;
        }
        EXPECT_NEAR(color_of(ray, technique, values).a, std::exp(-total_absorbance(ray)), 1e-6)
            << "A(1) is exact";
    }
    EXPECT_GT(ringing, RAYS) << "transmittance that rises again is the price of the series";
}

// Mean of the step function A over [low, high) of scaled depth.
double mean_absorbance(const ViewRay& ray, double low, double high) {
    double sum = 0;
    for (const Fragment& fragment : ray.fragments) {
        const double at = unit_depth(fragment.depth) * 15 / 16;
        sum += absorbance_of(fragment) * std::clamp((high - at) / (high - low), 0.0, 1.0);
    }
    return sum;
}

TEST(Wavelet, InterpolatesTheMeansOfTheCells) {
    const Technique& technique = require_technique("wavelet");
    RandomNumbers random(22);
    for (int i = 0; i < RAYS; ++i) {
        const ViewRay ray = random_ray(random, 1 + i % 12);
        const std::vector<float> depths = even_depths(61);
        const auto t = method_transmittance(ray, technique, technique.method_settings({}), depths);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            const double x = unit_depth(depths[d]) * 15;
            const double cell = std::min(std::floor(x), 15.0);
            const double before = cell > 0 ? mean_absorbance(ray, (cell - 1) / 16, cell / 16) : 0;
            const double here = mean_absorbance(ray, cell / 16, (cell + 1) / 16);
            EXPECT_NEAR(static_cast<double>(t[d]), std::exp(-(before + (x - cell) * (here - before))), 2e-5);
        }
        EXPECT_NEAR(color_of(ray, technique, {}).a, std::exp(-total_absorbance(ray)), 1e-5)
            << "totals are exact";
    }
}

struct Node {
    double depth, t;
};

// The published algorithm on vectors.
std::vector<Node> adaptive_nodes(const ViewRay& ray, std::size_t most) {
    std::vector<Node> nodes;
    for (const Fragment& fragment : ray.fragments) {
        const double at = static_cast<double>(0.5f * (fragment.depth + 1.0f));
        const double through = 1 - opacity_of(fragment);
        std::size_t i = 0;
        while (i < nodes.size() && nodes[i].depth < at) ++i;
        const double front = i > 0 ? nodes[i - 1].t : 1;
        for (std::size_t j = i; j < nodes.size(); ++j) nodes[j].t *= through;
        nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(i), {at, front * through});
        if (nodes.size() <= most) continue;
        std::size_t least = 1;
        const auto area = [&](std::size_t k) {
            return (nodes[k].depth - nodes[k - 1].depth) * (nodes[k - 1].t - nodes[k].t);
        };
        for (std::size_t k = 2; k + 1 < nodes.size(); ++k)
            if (area(k) < area(least)) least = k;
        nodes[least - 1].t = nodes[least].t;
        nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(least));
    }
    return nodes;
}

TEST(Adaptive, IsThePublishedAlgorithmAndNeverAboveTheTruth) {
    const Technique& technique = require_technique("at");
    RandomNumbers random(23);
    int other_nodes = 0, queries = 0;
    for (int i = 0; i < RAYS; ++i) {
        const int nodes = 2 + i % 7;
        const ViewRay ray = random_ray(random, 1 + i % 20);
        const ParameterValues values = values_of({{ParameterId::nodes, static_cast<float>(nodes)}});
        const std::vector<float> depths = even_depths(41);
        const auto t = method_transmittance(ray, technique, technique.method_settings(values), depths);
        const auto expected = adaptive_nodes(ray, static_cast<std::size_t>(nodes));
        const auto truth = true_absorbance(ray, depths);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            double t_expected = 1;
            for (const Node& node : expected)
                if (node.depth < unit_depth(depths[d])) t_expected = node.t;
            // Areas that are equal in floats, as of products of T below 1e-7, may choose another node.
            other_nodes += std::abs(static_cast<double>(t[d]) - t_expected) > 1e-5 ? 1 : 0;
            ++queries;
            EXPECT_LE(static_cast<double>(t[d]), std::exp(-truth[d]) + 1e-6);
            if (ray.fragments.size() <= static_cast<std::size_t>(nodes)) {
                EXPECT_NEAR(static_cast<double>(t[d]), std::exp(-truth[d]), 1e-6);
            }
        }
        EXPECT_NEAR(color_of(ray, technique, values).a, std::exp(-total_absorbance(ray)), 1e-6);
    }
    EXPECT_LE(other_nodes, queries / 1000);
}

struct ExactLayer {
    double depth;
    glm::dvec4 color;  // premultiplied, transmittance
};

std::vector<ExactLayer> exact_layers(const ViewRay& ray, std::size_t most) {
    std::vector<ExactLayer> layers;
    for (const Fragment& f : ray.fragments) {
        const ExactLayer layer = {static_cast<double>(f.depth),
                                  glm::dvec4(glm::dvec3(f.color) * opacity_of(f), 1 - opacity_of(f))};
        const auto place = std::ranges::upper_bound(layers, layer.depth, {}, &ExactLayer::depth);
        layers.insert(place, layer);
        if (layers.size() <= most) continue;
        const ExactLayer last = layers.back();
        layers.pop_back();
        glm::dvec4& into = layers.back().color;
        into = glm::dvec4(glm::dvec3(into) + into.a * glm::dvec3(last.color), into.a * last.color.a);
    }
    return layers;
}

TEST(Layered, IsThePublishedAlgorithmAndExactWithEnoughLayers) {
    const Technique& technique = require_technique("mlab");
    RandomNumbers random(24);
    for (int i = 0; i < RAYS; ++i) {
        const int count = 1 + i % 6;
        const ViewRay ray = colored_ray(random, 1 + i % 15);
        glm::dvec4 expected(0, 0, 0, 1);
        for (const ExactLayer& layer : exact_layers(ray, static_cast<std::size_t>(count)))
            expected = glm::dvec4(glm::dvec3(expected) + expected.a * glm::dvec3(layer.color),
                                  expected.a * layer.color.a);
        const auto with_bits = [&](float bits) {
            return color_of(ray, technique,
                            values_of({{ParameterId::layers, static_cast<float>(count)},
                                       {ParameterId::layer_bits, bits}}));
        };
        expect_near(with_bits(2), expected, 1e-6);
        if (ray.fragments.size() <= static_cast<std::size_t>(count)) {
            expect_near(with_bits(2), true_color(ray), 1e-6);
        }
        // Half a unit of 11 bits, or of 1/255, for each of up to 15 fragments that are merged.
        expect_near(with_bits(0), expected, 1e-2);
        expect_near(with_bits(1), expected, 4e-2);
    }
}

// Depths 1e-6 apart are the same 16-bit number: the one that came first is in front.
TEST(Layered, SixteenBitDepthsTie) {
    ViewRay ray;
    ray.fragments = {{.depth = 0.100001f, .view_depth = 0, .opacity = 0.5f, .color = {1, 0, 0}},
                     {.depth = 0.1f, .view_depth = 0, .opacity = 0.5f, .color = {0, 1, 0}}};
    const Technique& technique = require_technique("mlab");
    EXPECT_GT(color_of(ray, technique, values_of({{ParameterId::layer_bits, 2.0f}})).g, 0.49);
    EXPECT_LT(color_of(ray, technique, values_of({{ParameterId::layer_bits, 0.0f}})).g, 0.26);
}

double weight_of(const MethodFragment& f, int kind) {
    const double alpha = static_cast<double>(f.opacity), z = static_cast<double>(f.window_depth);
    const double view = static_cast<double>(f.view_depth);
    if (kind == 0) return std::clamp(std::pow(10 * (1 - .99 * z) * alpha, 3), .01, 30.0);
    if (kind == 2) return std::clamp(1e3 * std::pow((8 * alpha + .01) * (1 - .95 * z), 3), .01, 300.0);
    const double brightest = static_cast<double>(std::max({f.red, f.green, f.blue})) * alpha;
    const double bright = std::min(1.0, 40 * std::max(brightest, alpha) + .01);
    return std::clamp(.03 / (1e-5 + std::pow(view / 200, 4)), .01, 3e3) * bright * bright;
}

TEST(Weighted, IsTheWeightedMeanOverTheCoverageAndExactForOneFragment) {
    const Technique& technique = require_technique("wboit");
    RandomNumbers random(25);
    for (int i = 0; i < RAYS; ++i) {
        const int kind = i % 3;
        ViewRay ray = colored_ray(random, 1 + i % 8);
        const ParameterValues values = values_of({{ParameterId::weight, static_cast<float>(kind)}});
        glm::dvec4 sum(0);
        for (const Fragment& f : ray.fragments)
            sum +=
                glm::dvec4(glm::dvec3(f.color), 1) * opacity_of(f) * weight_of(method_fragment(ray, f), kind);
        const double t = std::exp(-total_absorbance(ray));
        const glm::dvec4 color = color_of(ray, technique, values);
        expect_near(color, glm::dvec4(glm::dvec3(sum) / sum.a * (1 - t), t), 1e-5);
        if (ray.fragments.size() == 1) expect_near(color, true_color(ray), 1e-5);
        const auto own = own_transmittance(ray, technique, technique.method_settings(values));
        glm::dvec3 seen(0);
        for (std::size_t k = 0; k < own.size(); ++k)
            seen += glm::dvec3(ray.fragments[k].color) * opacity_of(ray.fragments[k]) *
                    static_cast<double>(own[k]);
        expect_near(glm::dvec4(seen, t), color, 1e-5);
    }
}

TEST(Unsorted, IsExactFromBackToFrontAndTellsWhatIsSeen) {
    const Technique& technique = require_technique("unsorted");
    RandomNumbers random(26);
    for (int i = 0; i < RAYS; ++i) {
        ViewRay ray = colored_ray(random, 2 + i % 8);
        std::ranges::sort(ray.fragments, std::greater<>(), &Fragment::depth);
        expect_near(color_of(ray, technique, {}), true_color(ray), 1e-6);
        std::ranges::reverse(ray.fragments);  // the worst order: the last fragment hides all others
        const auto own = own_transmittance(ray, technique, {});
        double t = 1;
        for (std::size_t k = own.size(); k-- > 0;) {
            EXPECT_NEAR(static_cast<double>(own[k]), t, 1e-5);
            t *= 1 - opacity_of(ray.fragments[k]);
        }
    }
    EXPECT_FALSE(has_function(technique));
}

// Other random numbers for the same ray.
ViewRay reseeded(ViewRay ray, std::uint32_t run) {
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        ray.fragments[i].seed = fragment_seed(run, static_cast<std::uint32_t>(i), 77);
        ray.fragments[i].threshold = unit_random(ray.fragments[i].seed, 0);
    }
    return ray;
}

TEST(Stochastic, CountsTheSamplesThatSeeADepth) {
    const Technique& technique = require_technique("stochastic");
    RandomNumbers random(27);
    for (int i = 0; i < RAYS; ++i) {
        const ViewRay ray = reseeded(random_ray(random, 1 + i % 12), static_cast<std::uint32_t>(i));
        const int samples = 1 + i % 64;
        const ParameterValues values = values_of({{ParameterId::samples, static_cast<float>(samples)},
                                                  {ParameterId::renormalize, i % 2 == 0 ? 1.0f : 0.0f}});
        std::vector<double> nearest(static_cast<std::size_t>(samples), 9);
        for (const Fragment& f : ray.fragments)
            for (int s = 0; s < samples; ++s)
                if (unit_random(f.seed, s) < f.opacity)
                    nearest[static_cast<std::size_t>(s)] =
                        std::min(nearest[static_cast<std::size_t>(s)], static_cast<double>(f.depth));
        const auto own = own_transmittance(ray, technique, technique.method_settings(values));
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

// Unbiased, and the error falls with the root of the samples.
TEST(Stochastic, ConvergesWithTheRootOfTheSamples) {
    const Technique& technique = require_technique("stochastic");
    RandomNumbers random(28);
    constexpr int RUNS = 4000;
    for (const int samples : {1, 4, 16, 64}) {
        const ParameterValues values = values_of({{ParameterId::samples, static_cast<float>(samples)}});
        double squares = 0, sum = 0, expected_squares = 0;
        for (int run = 0; run < RUNS; ++run) {
            const ViewRay ray =
                reseeded(random_ray(random, 6), static_cast<std::uint32_t>(run * 64 + samples));
            const std::vector<float> depth = {0.25f};
            const double truth = std::exp(-true_absorbance(ray, depth)[0]);
            const double t = static_cast<double>(
                method_transmittance(ray, technique, technique.method_settings(values), depth)[0]);
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
                0.01);  // right on average
}

// Kolmogorov and Smirnov: 100,000 uniform numbers stay within .0061 of their distribution with 99.9 %
// probability; places on a grid are less random than that.
TEST(Hashed, ThresholdsAreUniform) {
    RandomNumbers random(30);
    for (const float width : {0.9f, 0.013f, 0.0031f}) {
        std::vector<double> thresholds;
        for (int i = 0; i < 100'000; ++i)
            thresholds.push_back(static_cast<double>(parts::alpha_threshold(
                random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30), width)));
        std::ranges::sort(thresholds);
        double worst = 0;
        for (std::size_t i = 0; i < thresholds.size(); ++i)
            worst = std::max(worst, std::abs(thresholds[i] - static_cast<double>(i) / 100'000));
        EXPECT_LT(worst, 0.01) << width;
    }
}

// The ray as Moment Transparency sees it: depths between the planes, logarithmically, as depths in [-1, 1] or
// [0, 1].
ViewRay between_planes(const ViewRay& ray, bool published) {
    ViewRay result = ray;
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const float z = method_fragment(ray, ray.fragments[i]).plane_depth;
        result.fragments[i].depth = result.fragments[i].view_depth = published ? z : 2 * z - 1;
    }
    return result;
}

ViewRay ray_between_planes(RandomNumbers& random, int count) {
    ViewRay ray = random_ray(random, count);
    ray.warp = {true, 0.2f, 60.0f};
    ray.near_plane = 0.1f;
    ray.far_plane = 100;
    for (Fragment& fragment : ray.fragments) fragment.view_depth = to_view_depth(fragment.depth, ray.warp);
    return ray;
}

double quantile(std::vector<double>& values, double q) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

TEST(MomentTransparency, IsFourExactMomentsBetweenThePlanes) {
    const Technique& technique = require_technique("mt");
    RandomNumbers random(31);
    for (const bool published : {false, true}) {
        std::vector<double> errors;
        for (int i = 0; i < 2000; ++i) {
            const ViewRay ray = ray_between_planes(random, 1 + i % 8);
            const ParameterValues values = values_of({{ParameterId::depth_range, published ? 1.0f : 0.0f}});
            const auto own = own_transmittance(ray, technique, technique.method_settings(values));
            const ViewRay mapped = between_planes(ray, published);
            const auto exact = exact_function(mapped, require_technique("power4-32"), {.alpha = 3e-7f});
            std::vector<float> depths;
            for (const Fragment& f : mapped.fragments) depths.push_back(f.depth);
            const auto absorbance = exact_absorbance(exact, mapped, 0.25f, depths);
            for (std::size_t k = 0; k < own.size(); ++k)
                errors.push_back(std::abs(static_cast<double>(own[k]) - std::exp(-absorbance[k])));
        }
        // In [0, 1] moments are so much closer to singular that floats show: what the correction is for.
        EXPECT_LT(quantile(errors, 0.5), 1e-5) << published;
        EXPECT_LT(quantile(errors, 0.99), published ? 2e-2 : 2e-4) << published;
    }
}

// Sets of the second pass, put together by hand from exact moments of the fragments as the first lets them be
// seen.
TEST(MomentTransparency, TheSecondSetKnowsTheFirst) {
    const Technique& technique = require_technique("mt");
    const Technique& moments = require_technique("power4-32");
    RandomNumbers random(32);
    for (const int passes : {1, 2}) {
        std::vector<double> errors, changes;
        for (int i = 0; i < 2000; ++i) {
            const ViewRay ray = ray_between_planes(random, 1 + i % 8);
            const ParameterValues values =
                values_of({{ParameterId::moment_passes, static_cast<float>(passes)}});
            const auto own = own_transmittance(ray, technique, technique.method_settings(values));
            const auto first = own_transmittance(ray, technique, technique.method_settings({}));
            ViewRay seen = between_planes(ray, false);
            std::vector<float> depths;
            for (std::size_t k = 0; k < first.size(); ++k) {
                Fragment& f = seen.fragments[k];
                const float visibility = f.opacity * first[k];
                f.opacity = passes == 1 ? visibility : 1 - std::exp(-visibility);  // whose absorbance is it
                depths.push_back(f.depth);
            }
            const auto exact = exact_function(seen, moments, {.alpha = 3e-7f});
            const auto absorbance = exact_absorbance(exact, seen, 0.25f, depths);
            const double total = total_absorbance(ray), t = std::exp(-total);
            for (std::size_t k = 0; k < own.size(); ++k) {
                const double fraction = absorbance[k] / total_absorbance(seen);
                const double expected = passes == 1 ? std::exp(-total * fraction) : 1 - (1 - t) * fraction;
                errors.push_back(std::abs(static_cast<double>(own[k]) - expected));
                changes.push_back(std::abs(static_cast<double>(own[k] - first[k])));
            }
        }
        EXPECT_LT(quantile(errors, 0.5), 2e-5) << passes;
        EXPECT_LT(quantile(errors, 0.99), 1e-3) << passes;
        EXPECT_GT(quantile(changes, 0.5), 1e-3) << "a second set that changes nothing is none";
    }
}

TEST(MomentTransparency, ReadFormatsRoundAsMuchAsTheyShould) {
    const Technique& technique = require_technique("mt");
    RandomNumbers random(33);
    std::array<std::vector<double>, 4> errors;
    for (int i = 0; i < 4000; ++i) {
        const ViewRay ray = ray_between_planes(random, 1 + i % 8);
        const auto with_format = [&](int format, float bias) {
            return method_transmittance(
                ray, technique,
                technique.method_settings(values_of(
                    {{ParameterId::read_format, static_cast<float>(format)}, {ParameterId::alpha, bias}})),
                even_depths(31));
        };
        for (std::size_t format = 1; format < 4; ++format) {
            const float bias = format == 1 ? 6e-5f : 3e-7f;  // each against floats with the same α
            const auto floats = with_format(0, bias), rounded = with_format(static_cast<int>(format), bias);
            for (std::size_t d = 0; d < floats.size(); ++d)
                errors[format].push_back(std::abs(static_cast<double>(rounded[d] - floats[d])));
        }
    }
    EXPECT_LT(quantile(errors[1], 0.5), 1e-3);
    EXPECT_LT(quantile(errors[1], 0.99), 0.1);
    EXPECT_LT(quantile(errors[2], 0.99), 1e-4) << "64 bits cannot be told from floats";
    EXPECT_LT(quantile(errors[3], 0.5), 5e-3);
    EXPECT_LT(quantile(errors[3], 0.99), 0.15);
    EXPECT_GT(quantile(errors[3], 0.5), 1e-4) << "32 bits do round";
}

// Without rounding, the closed form of two depths is Algorithm 1.
TEST(MomentTransparency, TwoDepthsAreAlgorithmOneInAnotherForm) {
    const Technique& moments = require_technique("power4-32");
    RandomNumbers random(34);
    std::vector<double> errors;
    for (int i = 0; i < 3000; ++i) {
        const ViewRay ray = random_ray(random, 3 + i % 8);
        MomentVector sum;
        for (const Fragment& f : ray.fragments)
            moments.kernel->add_fragment(sum, f.depth, fragment_absorbance(f.opacity), 0);
        float b[4];
        const float targets[4] = {0, 0.375f, 0, 0.375f};
        for (std::size_t k = 0; k < 4; ++k)
            b[k] = (1 - 1e-4f) * sum.b[k] / sum.b0 + 1e-4f * targets[k];  // where floats are good for both
        const parts::TwoDepths exact = parts::two_depths(b[0], b[1], b[2], b[3]);
        for (const float depth : {-0.9f, -0.5f, -0.1f, 0.2f, 0.6f, 0.95f})
            for (const float beta : {0.0f, 0.25f, 1.0f}) {
                const double fraction = static_cast<double>(
                    moments.kernel->fraction(sum, {.overestimation = beta, .bias = 1e-4f}, depth));
                errors.push_back(std::abs(
                    fraction - static_cast<double>(parts::fraction_of_two_depths(exact, depth, beta))));
            }
    }
    EXPECT_LT(quantile(errors, 0.5), 1e-5);
    EXPECT_LT(quantile(errors, 0.99), 2e-3);
}

}  // namespace
}  // namespace momentscope::test
