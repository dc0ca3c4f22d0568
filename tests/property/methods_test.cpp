// methods_test.cpp -- compares techniques without moments with their definitions, which are written a second
// time in double precision.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/inspect/curve.hpp"
#include "tests/property/pixel_state_support.hpp"

namespace momentscope::test {
namespace {

constexpr int RAYS = 300;

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
        const ParameterValues values = values_with(
            {{ParameterId::coefficients, many ? 1.0f : 0.0f}, {ParameterId::lanczos, lanczos ? 1.0f : 0.0f}});
        const std::vector<float> depths = even_depths(33);
        const auto t = pixel_state_transmittance(ray, technique, resolve(values, technique).settings, depths);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            const double exact = fourier_absorbance(ray, many ? 7 : 3, lanczos, unit_depth(depths[d]));
            // A is up to 36 in floats. The error of T is at most the relative error of A.
            EXPECT_NEAR(static_cast<double>(t[d]), std::exp(-std::max(exact, 0.0)), 2e-5);
            if (d > 0) ringing += t[d] > t[d - 1] * 1.0001f ? 1 : 0;
        }
        EXPECT_NEAR(color_of(ray, technique, values).a, std::exp(-total_absorbance(ray)), 1e-6)
            << "A(1) is exact";
    }
    EXPECT_GT(ringing, RAYS) << "transmittance that rises again is the price of the series";
}

// The mean of the step function A over [low, high) of scaled depth.
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
        const auto t = pixel_state_transmittance(ray, technique, resolve({}, technique).settings, depths);
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

// The published algorithm, with vectors.
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
        const ParameterValues values = values_with({{ParameterId::nodes, static_cast<float>(nodes)}});
        const std::vector<float> depths = even_depths(41);
        const auto t = pixel_state_transmittance(ray, technique, resolve(values, technique).settings, depths);
        const auto expected = adaptive_nodes(ray, static_cast<std::size_t>(nodes));
        const auto truth = true_absorbance(ray, depths);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            double t_expected = 1;
            for (const Node& node : expected)
                if (node.depth < unit_depth(depths[d])) t_expected = node.t;
            // Areas that are equal in floats, such as products of T below 1e-7, may lead to another node.
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
        const auto place = std::ranges::lower_bound(layers, layer.depth, {}, &ExactLayer::depth);
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
                            values_with({{ParameterId::layers, static_cast<float>(count)},
                                         {ParameterId::layer_bits, bits}}));
        };
        expect_near(with_bits(2), expected, 1e-6);
        if (ray.fragments.size() <= static_cast<std::size_t>(count)) {
            expect_near(with_bits(2), true_color(ray), 1e-6);
        }
        // Half a unit of 11 bits, or of 1/255, for each of up to 15 merged fragments.
        expect_near(with_bits(0), expected, 1e-2);
        expect_near(with_bits(1), expected, 4e-2);
    }
}

// All techniques have the same cap: an opaque fragment counts as an absorbance of 10, two as 20. If a method
// lets nothing through, this is 10, or the ray's total if that is greater.
TEST(Methods, AnOpaqueFragmentCountsAsTen) {
    const std::vector<float> depths = {-0.5f, 0.0f, 0.5f};
    ViewRay ray;
    for (const float depth : {-0.2f, 0.2f})
        ray.fragments.push_back({.depth = depth, .view_depth = depth, .opacity = 1});
    for (const char* id : {"at", "mlab"}) {
        const Curve curve =
            sample_curve(ray, require_technique(id), values_with({{ParameterId::layer_bits, 2}}), depths);
        for (std::size_t i = 0; i < depths.size(); ++i)
            EXPECT_NEAR(curve.reconstructed[i], 10.0f * static_cast<float>(i), 2e-2f) << id;
    }
    for (const char* id : {"hashed", "stochastic"}) {
        const Curve both = sample_curve(ray, require_technique(id), {}, depths);
        EXPECT_NEAR(both.reconstructed[2], 20, 1e-3f) << id;
        ViewRay one = ray;
        one.fragments.resize(1);
        one.fragments[0].opacity = 0.9f;  // both draw it with this seed
        one.fragments[0].threshold = 0.5f;
        EXPECT_EQ(sample_curve(one, require_technique("hashed"), {}, depths).reconstructed[2],
                  fragment_absorbance(1.0f));
    }
}

// Depths 1e-6 apart are the same 16-bit number. The fragment that came last is in front, as for equal depths
// in `sorted`.
TEST(Layered, SixteenBitDepthsTie) {
    ViewRay ray;
    ray.fragments = {{.depth = 0.1f, .view_depth = 0, .opacity = 0.5f, .color = {0, 1, 0}},
                     {.depth = 0.100001f, .view_depth = 0, .opacity = 0.5f, .color = {1, 0, 0}}};
    const Technique& technique = require_technique("mlab");
    EXPECT_GT(color_of(ray, technique, values_with({{ParameterId::layer_bits, 2.0f}})).g, 0.49);
    EXPECT_LT(color_of(ray, technique, values_with({{ParameterId::layer_bits, 0.0f}})).g, 0.26);
}

double weight_of(const PixelStateFragment& f, int kind) {
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
        const ParameterValues values = values_with({{ParameterId::weight, static_cast<float>(kind)}});
        glm::dvec4 sum(0);
        for (const Fragment& f : ray.fragments)
            sum += glm::dvec4(glm::dvec3(f.color), 1) * opacity_of(f) *
                   weight_of(pixel_state_fragment(ray, f), kind);
        const double t = std::exp(-total_absorbance(ray));
        const glm::dvec4 color = color_of(ray, technique, values);
        expect_near(color, glm::dvec4(glm::dvec3(sum) / sum.a * (1 - t), t), 1e-5);
        if (ray.fragments.size() == 1) expect_near(color, true_color(ray), 1e-5);
        const auto own = own_transmittance(ray, technique, resolve(values, technique).settings);
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

// For all depths, their quotients stay finite.
TEST(Weighted, IsANumberOnEveryWarp) {
    const Technique& technique = require_technique("wboit");
    for (const auto& [near, far] :
         {std::pair(1e-30f, 1e38f), std::pair(1e-30f, 1.1e-30f), std::pair(1e37f, 1e38f)})
        for (int weight = 0; weight < 3; ++weight) {
            ViewRay ray;
            ray.warp = {DepthWarp::Kind::logarithmic, near, far};
            ray.near_plane = near;
            ray.far_plane = far;
            for (const float view_depth : {near, std::sqrt(near) * std::sqrt(far), far})
                ray.fragments.push_back({to_depth(view_depth, ray.warp), view_depth, 0.5f, glm::vec3(0.5f)});
            const ParameterValues values = values_with({{ParameterId::weight, static_cast<float>(weight)}});
            const glm::vec4 color = color_of(ray, technique, values);
            for (int c = 0; c < 4; ++c)
                EXPECT_TRUE(std::isfinite(color[c])) << near << ' ' << far << ' ' << weight;
            EXPECT_NEAR(color.a, 0.125f, 1e-6f);
        }
}

}  // namespace
}  // namespace momentscope::test
