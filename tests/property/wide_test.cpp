// wide_test.cpp -- curves are computed many depths at a time; the bits must be those of one depth alone.
#include <gtest/gtest.h>

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
            sample_curve(ray, *GetParam(), {}, even_depths(67));  // 67: leaves a rest for any width
        const ReconstructionSettings settings = settings_of(curve.parameters);
        for (std::size_t k = 0; k < curve.depth.size(); ++k)
            ASSERT_EQ(curve.reconstructed[k],
                      GetParam()->kernel->steps(curve.moments, settings, curve.depth[k]).absorbance);
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Wide, testing::ValuesIn(moment_based_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
