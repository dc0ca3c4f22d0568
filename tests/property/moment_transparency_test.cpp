// moment_transparency_test.cpp -- compares Moment Transparency with exact moments, and its read formats with
// floats.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/inspect/curve.hpp"
#include "core/inspect/exact.hpp"
#include "core/support/glsl.hpp"
#include "tests/property/pixel_state_support.hpp"

namespace momentscope::glsl::two_depths_parts {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// portable_math first, because the others use it
#include "shaders/shared/rounding.glsl"
// this one uses rounding
#include "shaders/shared/nonlinear_quantisation.glsl"
#pragma GCC diagnostic pop
}  // namespace momentscope::glsl::two_depths_parts

namespace momentscope::test {
namespace {

namespace parts = glsl::two_depths_parts;

// The ray as Moment Transparency sees it: logarithmic depths between the planes, mapped to [-1, 1] or [0, 1].
ViewRay between_planes(const ViewRay& ray, bool published) {
    ViewRay result = ray;
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const float z = pixel_state_fragment(ray, ray.fragments[i]).plane_depth;
        result.fragments[i].depth = result.fragments[i].view_depth = published ? z : 2 * z - 1;
    }
    return result;
}

ViewRay ray_between_planes(RandomNumbers& random, int count) {
    ViewRay ray = random_ray(random, count);
    ray.warp = {DepthWarp::Kind::logarithmic, 0.2f, 60.0f};
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
            const ParameterValues values = values_with({{ParameterId::depth_range, published ? 1.0f : 0.0f}});
            const auto own = own_transmittance(ray, technique, resolve(values, technique).settings);
            const ViewRay mapped = between_planes(ray, published);
            const auto exact = exact_function(mapped, require_technique("power4-32"), {.alpha = 3e-7f});
            std::vector<float> depths;
            for (const Fragment& f : mapped.fragments) depths.push_back(f.depth);
            const auto absorbance = exact_absorbance(exact, mapped, 0.25f, depths);
            for (std::size_t k = 0; k < own.size(); ++k)
                errors.push_back(std::abs(static_cast<double>(own[k]) - std::exp(-absorbance[k])));
        }
        // In [0, 1] moments are so much closer to singular that float rounding shows. This is the reason for
        // the correction.
        EXPECT_LT(quantile(errors, 0.5), 1e-5) << published;
        EXPECT_LT(quantile(errors, 0.99), published ? 2e-2 : 2e-4) << published;
    }
}

// The sets of the second pass, computed by hand from exact moments of the fragments with the visibility that
// the first pass gives them.
TEST(MomentTransparency, TheSecondSetKnowsTheFirst) {
    const Technique& technique = require_technique("mt");
    const Technique& moments = require_technique("power4-32");
    RandomNumbers random(32);
    for (const int passes : {1, 2}) {
        std::vector<double> errors, changes;
        for (int i = 0; i < 2000; ++i) {
            const ViewRay ray = ray_between_planes(random, 1 + i % 8);
            const ParameterValues values =
                values_with({{ParameterId::moment_passes, static_cast<float>(passes)}});
            const auto own = own_transmittance(ray, technique, resolve(values, technique).settings);
            const auto first = own_transmittance(ray, technique, resolve({}, technique).settings);
            ViewRay seen = between_planes(ray, false);
            std::vector<float> depths;
            for (std::size_t k = 0; k < first.size(); ++k) {
                Fragment& f = seen.fragments[k];
                const float visibility = f.opacity * first[k];
                // In the second reading the visibility is the absorbance.
                f.opacity = passes == 1 ? visibility : 1 - std::exp(-visibility);
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
            return pixel_state_transmittance(
                ray, technique,
                resolve(values_with({{ParameterId::read_format, static_cast<float>(format)},
                                     {ParameterId::alpha, bias}}),
                        technique)
                    .settings,
                even_depths(31));
        };
        for (std::size_t format = 1; format < 4; ++format) {
            const float bias = format == 1 ? 6e-5f : 3e-7f;  // compared with floats with the same α
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

// Without rounding, the closed form for two depths equals Algorithm 1.
TEST(MomentTransparency, TwoDepthsAreAlgorithmOneInAnotherForm) {
    const Technique& moments = require_technique("power4-32");
    RandomNumbers random(34);
    std::vector<double> errors;
    for (int i = 0; i < 3000; ++i) {
        const ViewRay ray = random_ray(random, 3 + i % 8);
        MomentVector sum;
        for (const Fragment& f : ray.fragments)
            moments.moment_kernel().add_fragment(sum, f.depth, fragment_absorbance(f.opacity), {});
        float b[4];
        const float targets[4] = {0, 0.375f, 0, 0.375f};
        for (std::size_t k = 0; k < 4; ++k)
            b[k] = (1 - 1e-4f) * sum.b[k] / sum.b0 + 1e-4f * targets[k];  // at this bias floats suit both
        const parts::TwoDepths exact = parts::two_depths(b[0], b[1], b[2], b[3]);
        for (const float depth : {-0.9f, -0.5f, -0.1f, 0.2f, 0.6f, 0.95f})
            for (const float beta : {0.0f, 0.25f, 1.0f}) {
                const double fraction = static_cast<double>(
                    moments.moment_kernel().fraction(sum, {.overestimation = beta, .bias = 1e-4f}, depth));
                errors.push_back(std::abs(
                    fraction - static_cast<double>(parts::fraction_of_two_depths(exact, depth, beta))));
            }
    }
    EXPECT_LT(quantile(errors, 0.5), 1e-5);
    EXPECT_LT(quantile(errors, 0.99), 2e-3);
}

}  // namespace
}  // namespace momentscope::test
