// quantisation.hpp -- the affine transforms Theta*_m, which make the most of 16 bits per power moment
// (supplementary, Table 2). Each has one matrix for odd moments and one for even moments. The offset of odd
// moments is 1/2. Inverses are computed.
#pragma once
#include <array>
#include <cstddef>

namespace momentscope {

template <std::size_t N>
using SquareMatrix = std::array<std::array<double, N>, N>;

template <std::size_t N>
struct QuantisationTransform {
    SquareMatrix<N> odd, even;
    std::array<double, N> even_offset;
};

/// The transform for m = 4, 6 or 8 power moments. `odd` acts on (b_1, b_3, ...) and `even` on (b_2, b_4,
/// ...), both normalised.
template <int M>
constexpr QuantisationTransform<M / 2> quantisation_transform() {
    constexpr double SQRT3 = 1.7320508075688772;
    if constexpr (M == 4)
        return {{{{1.5, -2.0}, {SQRT3 / 2, -2 * SQRT3 / 9}}}, {{{4.0, -4.0}, {0.5, 0.5}}}, {0.0, 0.0}};
    else if constexpr (M == 6)
        return {{{{2.5, -10.0, 8.0},
                  {-1.87499864450, 4.20757543111, -1.83257678661},
                  {1.26583039016, -1.47644882902, 0.71061660238}}},
                {{{4.0, -4.0, 0.0}, {9.0, -24.0, 16.0}, {-0.57759806484, 4.61936647543, -3.07953906655}}},
                {0.0, 0.0, 0.018888946}};
    else
        return {{{{3.48044635732474, -27.5760737514826, 55.1267384344761, -31.5311110403183},
                  {1.26797185782836, -0.928755808743913, -2.07520453231032, 1.23598848322588},
                  {-2.1671560004294, 6.17950199592966, -0.276515571579297, -4.23583042392097},
                  {0.974332879165755, -0.443426830933027, -0.360491648368785, 0.310149466050223}}},
                {{{0.280504133158527, -0.757633844606942, 0.392179589334688, -0.887531871812237},
                  {-2.01362265883247, 0.221551373038988, -1.06107954265125, 2.83887201588367},
                  {-7.31010494985321, 13.9855979699139, -0.114305766176437, -7.4361899359832},
                  {-15.8954215629556, 79.6186327084103, -127.457278992502, 63.7349456687829}}},
                {0.972481993925964, 1.0, 0.999179192513328, 0.991778293073131}};
}

/// The inverse, by Gauss-Jordan elimination with row exchanges. The matrix must be regular.
template <std::size_t N>
constexpr SquareMatrix<N> inverse(SquareMatrix<N> matrix) {
    SquareMatrix<N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i][i] = 1;
    const auto size = [](double x) { return x < 0 ? -x : x; };
    for (std::size_t k = 0; k < N; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < N; ++i)
            if (size(matrix[i][k]) > size(matrix[best][k])) best = i;
        const auto row = matrix[best];
        const auto result_row = result[best];
        matrix[best] = matrix[k];
        result[best] = result[k];
        for (std::size_t j = 0; j < N; ++j) {
            matrix[k][j] = row[j] / row[k];
            result[k][j] = result_row[j] / row[k];
        }
        for (std::size_t i = 0; i < N; ++i) {
            if (i == k) continue;
            const double factor = matrix[i][k];
            for (std::size_t j = 0; j < N; ++j) {
                matrix[i][j] -= factor * matrix[k][j];
                result[i][j] -= factor * result[k][j];
            }
        }
    }
    return result;
}

template <std::size_t N>
constexpr std::array<float, N> floats(const std::array<double, N>& values) {
    std::array<float, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<float>(values[i]);
    return result;
}

/// The entries row by row, as the shared source indexes them.
template <std::size_t N>
constexpr std::array<float, N * N> flat_floats(const SquareMatrix<N>& matrix) {
    std::array<float, N * N> result{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) result[i * N + j] = static_cast<float>(matrix[i][j]);
    return result;
}

}  // namespace momentscope
