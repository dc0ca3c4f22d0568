// bracketed_root.hpp -- a root that theory puts into a known interval, to the last digits a function allows.
#pragma once
#include <cmath>
#include <limits>

namespace momentscope::reference {

/// A function's value and slope, and the size of the rounding errors in `value`.
template <class Real>
struct Sample {
    Real value;
    Real slope;
    Real noise;
};

/// Root of `sample` in [low, high] by Newton steps, bisection where they leave the bracket or are slow.
/// The sign at `high` is passed, not evaluated: interlacing tells it, even where rounding hides it because
/// the root and an end of its bracket all but coincide. Then that end is returned.
template <class Real, class Function>
Real bracketed_root(const Function& sample, Real low, Real high, bool positive_at_high) {
    using std::abs;
    const int step_limit =
        4 * std::numeric_limits<Real>::digits;  // bisection alone would need about a quarter
    Real x = (low + high) / Real(2);
    Real previous_step = high - low;
    for (int i = 0; i < step_limit; ++i) {
        const Sample<Real> at = sample(x);
        if (abs(at.value) <= at.noise) return x;
        ((at.value > Real(0)) == positive_at_high ? high : low) = x;
        Real next = at.slope != Real(0) ? x - at.value / at.slope : low;
        const bool newton = next > low && next < high && Real(2) * abs(next - x) < abs(previous_step);
        if (!newton) next = (low + high) / Real(2);
        previous_step = next - x;
        if (abs(previous_step) <= std::numeric_limits<Real>::epsilon() * abs(next)) return next;
        x = next;
    }
    return x;
}

/// Root of `sample` beyond `edge`: in [edge, infinity) for direction = +1, in (-infinity, edge] for -1.
/// Returns +-infinity if there is no sign change within 2^100 of `edge`: such a root has a weight below
/// 1e-60.
template <class Real, class Function>
Real outer_root(const Function& sample, const Real& edge, int direction, bool positive_outside) {
    Real inner = edge;
    Real reach(1);
    for (int doubling = 0; doubling < 100; ++doubling, reach *= Real(2)) {
        const Real outer = edge + reach * Real(direction);
        const bool found = (sample(outer).value > Real(0)) == positive_outside;
        if (found && direction > 0) return bracketed_root(sample, inner, outer, positive_outside);
        if (found) return bracketed_root(sample, outer, inner, !positive_outside);
        inner = outer;
    }
    return std::numeric_limits<Real>::infinity() * Real(direction);
}

}  // namespace momentscope::reference
