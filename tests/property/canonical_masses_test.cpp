// canonical_masses_test.cpp -- tests what makes the sharp bounds of the line sharp.
#include "core/inspect/canonical_masses.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace momentscope::test {
namespace {

using reference::Extended;

// With these two properties, the inequalities of Chebyshev, Markov and Stieltjes hold for them.
TEST(CanonicalMasses, HaveTheMomentsAndLieInTheDepthRange) {
    std::mt19937 random(18);
    std::uniform_real_distribution<double> anywhere(-1, 1), any_mass(0.01, 1);
    using std::abs;
    using std::pow;
    Extended worst = 0;
    for (int degree = 2; degree <= 4; ++degree)
        for (int i = 0; i < 200; ++i) {
            std::vector<DepthMass> ray;
            Extended total = 0;
            for (int k = 0; k < 6 + i % 7; ++k) {
                ray.push_back({anywhere(random), any_mass(random)});
                if (k < 2 && i % 4 == 0) ray.back().depth = k == 0 ? -1 : 1;
                total += ray.back().mass;
            }
            for (DepthMass& one : ray) one.mass /= total;
            const auto canonical = CanonicalMasses::of(ray, degree);
            ASSERT_TRUE(canonical);
            const Extended depth = i % 3 == 0 ? ray[2].depth : static_cast<Extended>(anywhere(random));
            const std::vector<DepthMass> masses = canonical->at(depth);
            EXPECT_TRUE(
                std::ranges::any_of(masses, [&](const DepthMass& one) { return one.depth == depth; }));
            EXPECT_LE(masses.size(), static_cast<std::size_t>(degree) + 2);
            for (const DepthMass& one : masses) {
                EXPECT_GE(one.mass, -1e-15L);
                EXPECT_LE(abs(one.depth), 1 + 1e-9L);
            }
            for (int j = 0; j <= 2 * degree; ++j) {
                Extended difference = 0;
                for (const DepthMass& one : ray) difference += one.mass * pow(one.depth, j);
                for (const DepthMass& one : masses) difference -= one.mass * pow(one.depth, j);
                worst = std::max(worst, Extended(abs(difference)));
            }
        }
    fmt::print("moments are off by at most {:.1e}\n", static_cast<double>(worst));
    EXPECT_LT(worst, 1e-14L);
}

}  // namespace
}  // namespace momentscope::test
