// chebyshev_reference.hpp -- power moments of what Chebyshev moments stand for.
#pragma once
#include <array>
#include <cstddef>

#include "core/reference/point_masses.hpp"

namespace momentscope::reference {

/// The power moments (2k)! / (4^k k!^2) of the arcsine distribution, towards which Chebyshev moments are
/// biased.
template <class Number, std::size_t M>
PowerMoments<M, Number> arcsine_moments() {
    PowerMoments<M, Number> moments{};
    moments[0] = 1;
    for (std::size_t k = 2; k <= M; k += 2)
        moments[k] = moments[k - 2] * static_cast<Number>(k - 1) / static_cast<Number>(k);
    return moments;
}

/// Converts Chebyshev moments to power moments. z^k is expanded in T_j by z T_j = (T_{j+1} + T_{|j-1|}) / 2.
template <class Number, std::size_t M>
PowerMoments<M, Number> power_of_chebyshev(const std::array<Number, M + 1>& chebyshev) {
    PowerMoments<M, Number> power{};
    std::array<Number, M + 2> coefficient{};  // of z^k
    coefficient[0] = 1;
    for (std::size_t k = 0; k <= M; ++k) {
        for (std::size_t j = 0; j <= k; ++j) power[k] += coefficient[j] * chebyshev[j];
        std::array<Number, M + 2> next{};
        for (std::size_t j = 0; j <= k && j <= M; ++j) {
            next[j + 1] += coefficient[j] / (j == 0 ? 1 : 2);
            if (j > 0) next[j - 1] += coefficient[j] / 2;
        }
        coefficient = next;
    }
    return power;
}

}  // namespace momentscope::reference
