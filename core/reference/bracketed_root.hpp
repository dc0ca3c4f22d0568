// bracketed_root.hpp -- finds a root in an interval known from theory, to the last digits that the function
// allows.
#pragma once
#include <cmath>
#include <limits>

namespace momentscope::reference {

/// The value and the slope of a function, and the size of the rounding errors in `value`.
template <class Real>
struct Sample {
    Real value;
    Real slope;
    Real noise;
};

/// The root of `sample` in [low, high]. Takes Newton steps, and bisects if they leave the bracket or are
/// slow. The sign at `high` is an argument because it follows from interlacing, while rounding may hide it:
/// the root may nearly coincide with an end of its bracket. Then this end is returned.
template <class Real, class Function>
Real bracketed_root(const Function& sample, Real low, Real high, bool positive_at_high) {
    using std::abs;
    const int step_limit =
        4 * std::numeric_limits<Real>::digits;  // bisection alone would need about a quarter of these
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

/// The root of `sample` beyond `edge`: in [edge, infinity) for direction = +1, in (-infinity, edge] for -1.
/// Returns +-infinity if the sign does not change within 2^100 of `edge`: such a root has a weight below
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
    const Real infinity = std::numeric_limits<Real>::infinity();
    return direction > 0 ? infinity : Real(-infinity);
}

}  // namespace momentscope::reference
