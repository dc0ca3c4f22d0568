// extended_test.cpp -- the pairs of doubles that replace long double where it is too narrow or too slow
// (core/reference/extended.hpp): alone, in the exact curve and in the canonical masses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cfloat>
#include <chrono>
#include <random>

#include "core/inspect/canonical_masses.inl"
#include "core/inspect/exact.inl"
#include "core/reference/double_double.hpp"
#include "tests/effort.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"
#include "tests/property/wide_numbers.hpp"

namespace momentscope {
extern template class CanonicalMassesOf<reference::Extended>;  // of canonical_masses.cpp
}

namespace momentscope::test {
namespace {

using reference::DoubleDouble;
using Digits100 = boost::multiprecision::cpp_bin_float_100;

template <class Number>
Digits100 digits(const Number& number) {
    return widened<Digits100>(number);
}

class DoubleDoubles : public testing::Test {
protected:
    /// A number of 106 random bits, from 2^-20 to 2^20.
    DoubleDouble any() {
        std::uniform_real_distribution<double> part(-1, 1);
        const double high = std::ldexp(part(random), static_cast<int>(random() % 40) - 20);
        return DoubleDouble(high) + std::ldexp(high, -54) * part(random);
    }
    static void expect_near(const DoubleDouble& value, const Digits100& truth, const Digits100& size,
                            int bits) {
        ASSERT_LE(Digits100(abs(digits(value) - truth) / size), Digits100(std::exp2(-bits)))
            << value.high << " + " << value.low;
    }
    std::mt19937 random{1};
};

TEST_F(DoubleDoubles, ComputeWith102Bits) {
    for (int i = 0; i < effort(20'000, 1'000'000); ++i) {
        const DoubleDouble a = any(), b = any();
        const Digits100 x = digits(a), y = digits(b);
        expect_near(a + b, x + y, abs(x) + abs(y), 103);
        expect_near(a - b, x - y, abs(x) + abs(y), 103);
        expect_near(a * b, x * y, abs(Digits100(x * y)), 102);
        expect_near(a / b, x / y, abs(Digits100(x / y)), 102);
        expect_near(sqrt(abs(a)), sqrt(Digits100(abs(x))), sqrt(Digits100(abs(x))), 102);
        ASSERT_EQ(a < b, x < y);
        ASSERT_EQ(digits(round(a)), round(x));
        ASSERT_EQ(digits(ceil(a)), ceil(x));
    }
}

TEST_F(DoubleDoubles, HaveFunctionsOf96Bits) {
    std::uniform_real_distribution<double> part(-1, 1);
    for (int i = 0; i < effort(2'000, 100'000); ++i) {
        const DoubleDouble exponent = any() / (1 << 14);  // up to 64
        const Digits100 x = digits(exponent);
        expect_near(exp(exponent), exp(x), exp(x), 96);
        expect_near(expm1(exponent), expm1(x), abs(Digits100(expm1(x))), 96);
        const DoubleDouble opacity = DoubleDouble(part(random)) * (1 - std::ldexp(1, -int(random() % 40)));
        const Digits100 y = digits(opacity);
        if (opacity != 0) expect_near(log1p(opacity), log1p(y), abs(Digits100(log1p(y))), 96);
        expect_near(log(abs(exponent)), log(abs(x)), 1 + abs(Digits100(log(abs(x)))), 96);
        const DoubleDouble angle = any() / (1 << 15);  // up to five turns
        const Digits100 z = digits(angle);
        expect_near(sin(angle), sin(z), 1, 96);
        expect_near(cos(angle), cos(z), 1, 96);
        expect_near(sin(angle / 64), sin(Digits100(z / 64)), abs(Digits100(z / 64)), 96);
    }
}

TEST_F(DoubleDoubles, KeepInfinitiesAndHalves) {
    const DoubleDouble infinity = std::numeric_limits<DoubleDouble>::infinity();
    EXPECT_TRUE(isinf(infinity) && isinf(-infinity) && -infinity < DoubleDouble(0));
    EXPECT_TRUE(isnan(infinity * DoubleDouble(-1)) && isnan(infinity + DoubleDouble(1)));
    EXPECT_EQ(DoubleDouble(1) / infinity, DoubleDouble(0));
    EXPECT_EQ(DoubleDouble(1) / DoubleDouble(0), infinity);
    EXPECT_EQ(-log1p(DoubleDouble(-1)), infinity);
    EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0));
    EXPECT_EQ(ceil(DoubleDouble(2, 1e-20)), DoubleDouble(3));
    EXPECT_EQ(ceil(DoubleDouble(2, -1e-20)), DoubleDouble(2));
    EXPECT_EQ(round(DoubleDouble(2.5)), DoubleDouble(3));
    EXPECT_EQ(round(DoubleDouble(2.5, -1e-20)), DoubleDouble(2));
    EXPECT_EQ(round(DoubleDouble(-2.5)), DoubleDouble(-3));
    EXPECT_EQ(round(DoubleDouble(0.5, -1e-20)), DoubleDouble(0));
    EXPECT_EQ(static_cast<long double>(DoubleDouble(0.1L)), 0.1L);
}

class Errors {
public:
    void add(double error) { errors_.push_back(error); }
    double quantile(double share) {
        std::ranges::sort(errors_);
        return errors_[static_cast<std::size_t>(share * static_cast<double>(errors_.size() - 1))];
    }
    void print(const char* what) {
        fmt::print("{}: median {:.1e}, 99 % {:.1e}, worst {:.1e}\n", what, quantile(0.5), quantile(0.99),
                   quantile(1));
    }

private:
    std::vector<double> errors_;
};

template <class Number>
double distance(const Number& a, const Digits100& b) {
    return static_cast<double>(abs(digits(a) - b));
}

std::vector<ViewRay> random_rays(int count) {
    std::mt19937 random(2);
    std::vector<ViewRay> rays;
    for (int i = 0; i < count; ++i) rays.push_back(i % 2 == 0 ? random_ray(random) : clustered_ray(random));
    return rays;
}

/// The exact function of a technique. Those with the most moments need the most digits.
template <class Number>
std::optional<ExactFunctionOf<Number>> exact_in(BasisId basis, const ViewRay& ray,
                                                const ResolvedParameters& parameters) {
    using namespace any_precision;
    const auto masses = exact_masses<Number>(ray);
    if (basis == BasisId::power) return Exact<Number, BasisId::power, 8, 32>::of_masses(masses, parameters);
    if (basis == BasisId::nested) return Exact<Number, BasisId::nested, 8, 32>::of_masses(masses, parameters);
    return Exact<Number, BasisId::trigonometric, 4, 32>::of_masses(masses, parameters);
}

class ExactCurve : public testing::TestWithParam<const char*> {
protected:
    /// Errors of both fractions of b0 at the depths of the fragments.
    template <class Number>
    Errors errors() const {
        Errors errors;
        for (const ViewRay& ray : random_rays(effort(30, 2000))) {
            const auto exact = exact_in<Digits100>(basis, ray, parameters);
            const auto tried = exact_in<Number>(basis, ray, parameters);
            for (const Fragment& fragment : ray.fragments) {
                const auto truth = (*exact)(Digits100(fragment.depth));
                if (!tried) {
                    errors.add(1);  // these numbers take the matrix for singular
                    continue;
                }
                const auto result = (*tried)(static_cast<Number>(fragment.depth));
                errors.add(distance(result.in_front, truth.in_front));
                errors.add(distance(result.query_weight, truth.query_weight));
            }
        }
        return errors;
    }

    /// Seconds for a curve of 512 depths; `sum` is the sum of its values.
    template <class Number>
    double seconds(const ViewRay& ray, Number& sum) const {
        const auto start = std::chrono::steady_clock::now();
        const auto exact = exact_in<Number>(basis, ray, parameters);
        for (int k = 0; k < 512; ++k) sum += (*exact)(static_cast<Number>(k) / 256 - 1).in_front;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    const Technique& technique = require_technique(GetParam());
    const BasisId basis = technique.moments().basis->id;
    const ResolvedParameters parameters = resolve(ParameterValues(), technique);
};

// The matrix of the moments is badly conditioned: 99 % of the errors are below 1e-13, but only below 1e-10
// with doubles.
TEST_P(ExactCurve, IsAsExactWithPairsOfDoublesAsWithLongDouble) {
    Errors pairs = errors<DoubleDouble>(), hardware = errors<long double>();
    pairs.print("as two doubles");
    hardware.print("as long double");
    errors<double>().print("as double     ");
    EXPECT_LT(pairs.quantile(0.99), 1e-18);
}

// It asserts nothing about speed; docs/accuracy.md states the ratio.
TEST_P(ExactCurve, TakesLongerWithPairsOfDoubles) {
    std::mt19937 random(3);
    const ViewRay ray = random_ray(random);
    double pairs = 1e9, hardware = 1e9;
    DoubleDouble pairs_sum = 0;
    long double hardware_sum = 0;
    for (int round = 0; round < effort(3, 30); ++round) {  // interleaved; the quickest round counts
        hardware = std::min(hardware, seconds(ray, hardware_sum));
        pairs = std::min(pairs, seconds(ray, pairs_sum));
    }
    fmt::print("512 depths in {:.2f} ms as long double, in {:.1f} ms as two doubles: {:.1f} times as long\n",
               1e3 * hardware, 1e3 * pairs, pairs / hardware);
    EXPECT_NEAR(static_cast<double>(pairs_sum), static_cast<double>(hardware_sum), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Techniques, ExactCurve, testing::Values("power8-32", "trig4-32", "adaptive"),
                         [](const auto& row) { return test_name(require_technique(row.param)); });

/// The masses of a ray in any numbers; equal in all.
template <class Number>
std::vector<DepthMassOf<Number>> masses_of(const ViewRay& ray) {
    std::vector<DepthMassOf<Number>> masses;
    Number total = 0;
    for (const Fragment& fragment : ray.fragments) {
        masses.push_back({static_cast<Number>(fragment.depth), static_cast<Number>(fragment.opacity)});
        total += masses.back().mass;
    }
    for (auto& one : masses) one.mass /= total;
    return masses;
}

/// The mass in front of a depth, which is the lower sharp bound. nullopt if the moments determine the masses.
template <class Number>
std::optional<Number> mass_in_front(const ViewRay& ray, const Number& depth) {
    const auto canonical = CanonicalMassesOf<Number>::of(masses_of<Number>(ray), 4);
    if (!canonical) return std::nullopt;
    Number sum = 0;
    for (const auto& one : canonical->at(depth))
        if (one.depth < depth) sum += one.mass;
    return sum;
}

// They are compared with those of the program, which is quicker to compile than with 100 digits. Other tests
// look at their moments.
TEST(CanonicalMasses, AreTheSameWithPairsOfDoubles) {
    Errors errors;
    for (const ViewRay& ray : random_rays(effort(40, 2000))) {
        for (const double depth : {-0.7, 0.1, 0.6}) {
            const auto pairs = mass_in_front<DoubleDouble>(ray, depth);
            const auto usual = mass_in_front<reference::Extended>(ray, depth);
            ASSERT_EQ(pairs.has_value(), usual.has_value());
            if (pairs) errors.add(distance(*pairs, digits(*usual)));
        }
    }
    errors.print("difference");
    EXPECT_LT(errors.quantile(0.99), 1e-17);
}

}  // namespace
}  // namespace momentscope::test
