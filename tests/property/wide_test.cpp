// wide_test.cpp -- curves are computed for many depths at a time, and pictures for many pixels at a time. The
// bits must equal those of single computations.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

class Wide : public testing::TestWithParam<const Technique*> {};

TEST_P(Wide, EqualsScalar) {
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        const ViewRay ray = random_ray(random);
        const Curve curve =
            sample_curve(ray, *GetParam(), {}, even_depths(67));  // 67 leaves a remainder for any width
        const ReconstructionSettings settings = settings_of(curve.parameters);
        for (std::size_t k = 0; k < curve.depth.size(); ++k)
            ASSERT_EQ(curve.reconstructed[k],
                      GetParam()->moment_kernel().steps(curve.moments, settings, curve.depth[k]).absorbance);
    }
}

TEST_P(Wide, ManyPixelsEqualOne) {
    constexpr std::size_t PIXELS = 1003;  // full batches and a remainder
    const MomentKernel& kernel = GetParam()->moment_kernel();
    for (const bool textbook : {false, true}) {
        if (textbook && !kernel.has_textbook) continue;
        ParameterValues values;
        values.set(textbook ? Solver::textbook : Solver::robust);
        const ResolvedParameters parameters = resolve(values, *GetParam());
        const ReconstructionSettings settings = settings_of(parameters);
        std::mt19937 random(5);
        std::vector<MomentVector> moments(PIXELS);  // every seventh pixel stays empty
        std::vector<float> depths(PIXELS), fractions(PIXELS);
        for (std::size_t i = 0; i < PIXELS; ++i) {
            const ViewRay ray = random_ray(random);
            if (i % 7 != 0) moments[i] = sum_moments(ray, *GetParam(), parameters);
            depths[i] = ray.fragments.front().depth;
        }
        kernel.fractions(moments, settings, depths, fractions);
        for (std::size_t i = 0; i < PIXELS; ++i) {
            const float one = kernel.fraction(moments[i], settings, depths[i]);
            ASSERT_TRUE(fractions[i] == one || (std::isnan(one) && std::isnan(fractions[i])))
                << i << ": " << fractions[i] << " instead of " << one;
            ASSERT_TRUE(i % 7 != 0 || fractions[i] == 0.0f) << i;
        }
        kernel.fractions({}, settings, {}, {});
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Wide, testing::ValuesIn(kernel_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
