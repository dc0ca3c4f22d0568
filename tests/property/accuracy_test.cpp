// accuracy_test.cpp -- errors of T at the fragments' own depths, against exact arithmetic, by quantiles: an
// odd ray in a million is off whatever one does, because moments in floats do not determine it
// (docs/tolerances.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "core/ray/ray_json.hpp"
#include "tests/property/exact_technique.hpp"
#include "tests/property/random_rays.hpp"

#include <nlohmann/json.hpp>

namespace momentscope::test {
namespace {

struct Sample {
    float error;        // of T
    std::uint32_t ray;  // seed of its ray
};

struct Errors {
    std::vector<Sample> against_exact_moments;
    std::vector<float> against_float_moments;
    long without_exact_result = 0;  // the stored moments' matrix is not positive definite
    long floored_pivots = 0;
    long rays = 0;
};

ViewRay ray_of_seed(std::uint32_t seed) {
    std::mt19937 random(seed);
    return random_ray(random);
}

Real transmittance(const ExactFraction& exact, Real b0, float beta) {
    return std::exp(-b0 * (exact.in_front + static_cast<Real>(beta) * exact.query_weight));
}

void measure_ray(const Technique& technique, std::uint32_t seed, float beta, Errors& errors) {
    const ViewRay ray = ray_of_seed(seed);
    ParameterValues values;
    values.set(ParameterId::beta, beta);
    const std::vector<float> depths = own_depths(ray);
    const Curve curve = sample_curve(ray, technique, values, depths);
    const ExactPair exact = exact_pair(technique, ray, curve.moments, curve.parameters);
    ASSERT_TRUE(exact.from_exact_moments) << "exact moments with Table 1's bias must be positive definite";
    Real b0 = 0;
    for (const auto& mass : point_masses(ray)) b0 += mass.absorbance;
    ++errors.rays;
    const ReconstructionSettings settings = {beta, curve.parameters.theta, curve.parameters.alpha};
    errors.floored_pivots += technique.kernel->steps(curve.moments, settings, 0.0f).floored_pivots;
    if (!exact.from_float_moments) ++errors.without_exact_result;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const Real t = std::exp(-static_cast<Real>(curve.reconstructed[i]));
        const Real depth = static_cast<Real>(depths[i]);
        const Real ideal = transmittance((*exact.from_exact_moments)(depth), b0, beta);
        errors.against_exact_moments.push_back({static_cast<float>(std::abs(t - ideal)), seed});
        if (!exact.from_float_moments) continue;
        const Real same =
            transmittance((*exact.from_float_moments)(depth), static_cast<Real>(curve.moments.b0), beta);
        errors.against_float_moments.push_back(static_cast<float>(std::abs(t - same)));
    }
}

Errors measure(const Technique& technique, int rays, float beta) {
    constexpr std::uint32_t THREADS = 2;
    std::vector<Errors> parts(THREADS);
    {
        std::vector<std::jthread> threads;
        for (std::uint32_t part = 0; part < THREADS; ++part)
            threads.emplace_back([&, part] {
                for (auto seed = part; seed < static_cast<std::uint32_t>(rays); seed += THREADS)
                    measure_ray(technique, seed, beta, parts[part]);
            });
    }
    Errors& all = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        append(all.against_exact_moments, parts[i].against_exact_moments);
        append(all.against_float_moments, parts[i].against_float_moments);
        all.without_exact_result += parts[i].without_exact_result;
        all.floored_pivots += parts[i].floored_pivots;
        all.rays += parts[i].rays;
    }
    return all;
}

double mean(const auto& samples, auto value) {
    double sum = 0;
    for (const auto& sample : samples) sum += static_cast<double>(value(sample));
    return sum / static_cast<double>(samples.size());
}

class Accuracy : public testing::TestWithParam<std::tuple<const Technique*, float>> {};

TEST_P(Accuracy, AtOwnDepthsAgainstExactArithmetic) {
    const auto [technique, beta] = GetParam();
    Errors errors = measure(*technique, ray_count(100'000), beta);
    const auto error_of = [](const Sample& sample) { return sample.error; };
    std::ranges::sort(errors.against_exact_moments, {}, error_of);
    const auto quantile = [&](double share) {
        const auto last = static_cast<double>(errors.against_exact_moments.size() - 1);
        return errors.against_exact_moments[static_cast<std::size_t>(share * last)].error;
    };
    const double mean_exact = mean(errors.against_exact_moments, error_of);
    const double mean_float = mean(errors.against_float_moments, [](float error) { return error; });
    const Sample worst = errors.against_exact_moments.back();
    fmt::print(
        "{} beta {}: {} rays, error of T: mean {:.2e}, 99 % {:.2e}, 99.99 % {:.2e}, worst {:.2e}; from the "
        "same "
        "float moments: mean {:.2e}; no exact result {}; pivots floored {}\n  worst ray {}\n",
        technique->id, beta, errors.rays, mean_exact, quantile(0.99), quantile(0.9999), worst.error,
        mean_float, errors.without_exact_result, errors.floored_pivots,
        ray_to_json(ray_of_seed(worst.ray)).dump());
    EXPECT_LE(mean_exact, 8e-6);
    EXPECT_LE(quantile(0.99), 1e-4f);
    EXPECT_LE(quantile(0.9999), 5e-2f);
    EXPECT_LE(mean_float, 2e-6);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Accuracy,
                         testing::Combine(testing::ValuesIn(moment_based_techniques()),
                                          testing::Values(0.0f, 0.25f)),
                         [](const auto& row) {
                             const bool lower = std::get<1>(row.param) == 0;
                             return test_name(*std::get<0>(row.param)) + (lower ? "_beta0" : "_beta25");
                         });

}  // namespace
}  // namespace momentscope::test
