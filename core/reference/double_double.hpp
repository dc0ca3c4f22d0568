// double_double.hpp -- numbers of about 104 bits, each the sum of two doubles (Dekker 1971; Knuth, The Art of
// Computer Programming 2, 4.2.2). The exact curve computes with them where a long double has other bits than
// on x86. They are much quicker than numbers whose digits are integers.
#pragma once
#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <limits>

#include "core/reference/complex.hpp"

namespace momentscope::reference {

/// high + low, where |low| is at most half a unit in the last place of `high`. Sums, products and quotients
/// are off by at most 2^-102 of their operands. A number may be infinite: it can be compared and negated, and
/// quotients are right; sums and products of it are NaN, because a check would make all of them slower.
struct DoubleDouble {
    double high = 0;
    double low = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
    /// Exact up to 2^53.
    template <std::integral T>
    constexpr DoubleDouble(T number) : high(static_cast<double>(number)) {}
    template <std::floating_point T>
    constexpr DoubleDouble(T number) : high(static_cast<double>(number)) {
        if constexpr (std::numeric_limits<T>::digits > 53)
            if (is_finite(high)) low = static_cast<double>(number - static_cast<T>(high));
    }
    template <std::floating_point T>
    explicit constexpr operator T() const {
        return static_cast<T>(high) + static_cast<T>(low);
    }

    friend constexpr auto operator<=>(const DoubleDouble&, const DoubleDouble&) = default;
    friend constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
    friend constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const DoubleDouble sum = exact_sum(a.high, b.high);
        return normalised(sum.high, sum.low + (a.low + b.low));
    }
    friend constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    friend constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const DoubleDouble product = exact_product(a.high, b.high);
        return normalised(product.high, product.low + (a.high * b.low + a.low * b.high));
    }
    friend constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double first = a.high / b.high;
        if (!is_finite(first) || !is_finite(b.high)) return {first, 0};
        const DoubleDouble product = exact_product(first, b.high);
        const double rest = (a.high - product.high) - product.low + (a.low - first * b.low);
        return normalised(first, rest / b.high);
    }
    constexpr DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
    constexpr DoubleDouble& operator-=(const DoubleDouble& b) { return *this = *this - b; }
    constexpr DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }
    constexpr DoubleDouble& operator/=(const DoubleDouble& b) { return *this = *this / b; }

private:
    static constexpr bool is_finite(double x) { return x - x == 0; }

    // error: small beside sum.
    static constexpr DoubleDouble normalised(double sum, double error) {
        const double high = sum + error;
        return {high, error - (high - sum)};
    }
    // The sum and its rounding error.
    static constexpr DoubleDouble exact_sum(double a, double b) {
        const double sum = a + b;
        const double of_b = sum - a;
        return {sum, (a - (sum - of_b)) + (b - of_b)};
    }
    // The upper 26 bits of a double.
    static constexpr double upper(double a) {
        const double shifted = 134217729 * a;  // 2^27 + 1
        return shifted - (shifted - a);
    }
    // The product and its rounding error.
    static constexpr DoubleDouble exact_product(double a, double b) {
        const double product = a * b;
        const double a1 = upper(a), a2 = a - a1, b1 = upper(b), b2 = b - b1;
        return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
    }
};

template <>
inline DoubleDouble pi<DoubleDouble>() {
    return {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
}

constexpr DoubleDouble abs(const DoubleDouble& a) {
    return a.high < 0 ? -a : a;
}

inline bool isinf(const DoubleDouble& a) {
    return std::isinf(a.high);
}
inline bool isnan(const DoubleDouble& a) {
    return std::isnan(a.high);
}
inline bool isfinite(const DoubleDouble& a) {
    return std::isfinite(a.high);
}

/// Halves are rounded away from 0, as by std::round. |a| < 2^52.
inline DoubleDouble round(const DoubleDouble& a) {
    const double nearest = std::round(a.high);
    const double beyond = a.high - nearest;
    if (beyond == -0.5 && a.low < 0) return nearest - 1;
    if (beyond == 0.5 && a.low > 0) return nearest + 1;
    return nearest;
}

inline DoubleDouble ceil(const DoubleDouble& a) {
    const double above = std::ceil(a.high);
    return above == a.high && a.low > 0 ? above + 1 : above;
}

/// One Newton step from the root of `high`.
inline DoubleDouble sqrt(const DoubleDouble& a) {
    const double root = std::sqrt(a.high);
    if (!(root > 0) || std::isinf(root)) return root;
    const DoubleDouble rest = a - DoubleDouble(root) * root;
    return DoubleDouble(root) + rest.high / (2 * root);
}

/// exponent >= 0
constexpr DoubleDouble pow(const DoubleDouble& a, int exponent) {
    DoubleDouble power = 1;
    for (int i = 0; i < exponent; ++i) power *= a;
    return power;
}

namespace double_double {

constexpr int TERMS = 28;

// 1 / n!
inline constexpr auto INVERSE_FACTORIALS = [] {
    std::array<DoubleDouble, TERMS> values{};
    values[0] = 1;
    for (int n = 1; n < TERMS; ++n) values[n] = values[n - 1] / n;
    return values;
}();

// The terms of exp's series of orders first, first + step, ..., up to last, in powers of `x` = +-r^step.
inline DoubleDouble series(const DoubleDouble& x, int first, int last, int step) {
    DoubleDouble sum = INVERSE_FACTORIALS[last];
    for (int n = last - step; n >= first; n -= step) sum = sum * x + INVERSE_FACTORIALS[n];
    return sum;
}

// exp(x) - 1 for |x| < 0.7: the series of x / 2^9, whose ten terms suffice, then nine squares.
inline DoubleDouble small_expm1(const DoubleDouble& x) {
    const DoubleDouble part{x.high / 512, x.low / 512};
    DoubleDouble value = part * series(part, 1, 10, 1);
    for (int i = 0; i < 9; ++i) value = value * (value + 2);
    return value;
}

inline DoubleDouble small_sin(const DoubleDouble& x) {
    return x * series(-x * x, 1, 27, 2);
}
inline DoubleDouble small_cos(const DoubleDouble& x) {
    return series(-x * x, 0, 26, 2);
}

// sin(x + quarters pi / 2); x: any number whose distance from 0 is far below 2^50.
inline DoubleDouble shifted_sin(const DoubleDouble& x, int quarters) {
    const DoubleDouble half_pi = pi<DoubleDouble>() / 2;
    const DoubleDouble turns = round(x / half_pi);
    const DoubleDouble rest = x - turns * half_pi;
    const int quadrant = static_cast<int>((static_cast<long long>(turns.high) + quarters) & 3);
    const DoubleDouble value = quadrant % 2 == 0 ? small_sin(rest) : small_cos(rest);
    return quadrant < 2 ? value : -value;
}

}  // namespace double_double

inline DoubleDouble exp(const DoubleDouble& x) {
    if (!(std::abs(x.high) < 700)) return std::exp(x.high);  // overflows, vanishes, or is NaN
    const DoubleDouble log_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
    const double doublings = std::round(x.high / log_2.high);
    const DoubleDouble value = double_double::small_expm1(x - log_2 * doublings) + 1;
    const double scale = std::exp2(doublings);
    return {value.high * scale, value.low * scale};
}

inline DoubleDouble expm1(const DoubleDouble& x) {
    if (std::abs(x.high) < 0.5) return double_double::small_expm1(x);
    return exp(x) - 1;
}

/// One Newton step from the result for `high`.
inline DoubleDouble log(const DoubleDouble& x) {
    const double first = std::log(x.high);
    if (!std::isfinite(first)) return first;
    const DoubleDouble found = exp(first);
    return first + (x - found) / found;
}

/// log(1 + x)
inline DoubleDouble log1p(const DoubleDouble& x) {
    if (!(std::abs(x.high) < 0.5)) return log(1 + x);
    const double first = std::log1p(x.high);
    const DoubleDouble found = expm1(first);
    return first + (x - found) / (found + 1);
}

inline DoubleDouble sin(const DoubleDouble& x) {
    return double_double::shifted_sin(x, 0);
}
inline DoubleDouble cos(const DoubleDouble& x) {
    return double_double::shifted_sin(x, 1);
}

}  // namespace momentscope::reference

template <>
class std::numeric_limits<momentscope::reference::DoubleDouble> : public std::numeric_limits<double> {
    using Number = momentscope::reference::DoubleDouble;

public:
    static constexpr int digits = 102;  // those that results hold
    static constexpr int digits10 = 30;
    static constexpr int max_digits10 = 33;
    static constexpr bool is_iec559 = false;
    static constexpr Number min() noexcept { return {0x1p-960, 0}; }  // below it, errors of products vanish
    static constexpr Number max() noexcept { return {0x1p996, 0}; }   // beyond it, upper() overflows
    static constexpr Number lowest() noexcept { return {-0x1p996, 0}; }
    static constexpr Number epsilon() noexcept { return {0x1p-101, 0}; }
    static constexpr Number infinity() noexcept { return {std::numeric_limits<double>::infinity(), 0}; }
    static constexpr Number quiet_NaN() noexcept { return {std::numeric_limits<double>::quiet_NaN(), 0}; }
};
