// real_roots_tie_test.cpp -- polynomials in which a tie is the root nearest to the query. A Newton step from
// within the tie is the quotient of two rounding errors.
#include "core/support/glsl.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace momentscope::glsl::tied3 {
#define ROOT_COUNT 3
#include "shaders/shared/real_roots.glsl"
#undef ROOT_COUNT
}  // namespace momentscope::glsl::tied3
namespace momentscope::glsl::tied4 {
#include "shaders/shared/portable_math.glsl"
#define ROOT_COUNT 4
#include "shaders/shared/real_roots.glsl"
#undef ROOT_COUNT
}  // namespace momentscope::glsl::tied4

namespace {

namespace glsl = momentscope::glsl;

// Rounding the coefficients of a double root moves it by about the square root of 2^-24 times their size:
// 0.002. Ten times that is inaccurate, but still identifies the root among all others.
constexpr float WHERE_IT_IS = 0.02f;

TEST(CubicRoots, OfATieNearestToTheQueryStayWhereTheyAre) {
    // (t + 1.957) (t + 1.956) (t + 1.432)
    auto roots = glsl::tied3::real_roots({{5.345f, 9.431308f, 5.48154134f}});
    std::ranges::sort(roots.t);
    EXPECT_NEAR(roots.t[0], -1.957f, WHERE_IT_IS);
    EXPECT_NEAR(roots.t[1], -1.956f, WHERE_IT_IS);
    EXPECT_NEAR(roots.t[2], -1.432f, WHERE_IT_IS);
}

TEST(QuarticRoots, OfATieNearestToTheQueryStayWhereTheyAre) {
    // (t - .7) (t - 1.5) (t - 2)^2
    auto roots = glsl::tied4::real_roots({{-6.2f, 13.85f, -13.0f, 4.2f}});
    std::ranges::sort(roots.t);
    EXPECT_NEAR(roots.t[0], 0.7f, WHERE_IT_IS);
    EXPECT_NEAR(roots.t[1], 1.5f, WHERE_IT_IS);
    EXPECT_NEAR(roots.t[2], 2.0f, WHERE_IT_IS);
    EXPECT_NEAR(roots.t[3], 2.0f, WHERE_IT_IS);
}

}  // namespace
