// moment_kernel_functions.inl -- those functions of a MomentKernel that wider instruction sets make faster.
// moment_kernel.inl includes this file once for each instruction set, each time in another namespace.
namespace g {  // the shared source
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // all bases have the same signatures
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 cannot follow the triangular loops
// The order matters. A blank line keeps clang-format from sorting.
#include "shaders/shared/portable_math.glsl"

#include "shaders/shared/fragment.glsl"

#include MOMENT_BASIS
#ifdef THETA_TRANSFORM
constexpr auto THETA_ODD = flat_floats(quantisation_transform<MOMENT_COUNT>().odd);
constexpr auto THETA_EVEN = flat_floats(quantisation_transform<MOMENT_COUNT>().even);
constexpr auto THETA_ODD_INVERSE = flat_floats(inverse(quantisation_transform<MOMENT_COUNT>().odd));
constexpr auto THETA_EVEN_INVERSE = flat_floats(inverse(quantisation_transform<MOMENT_COUNT>().even));
constexpr auto THETA_EVEN_OFFSET = floats(quantisation_transform<MOMENT_COUNT>().even_offset);
#endif
#include "shaders/shared/reconstruction.glsl"

#include "shaders/shared/ends.glsl"

#include "shaders/shared/fragment_estimate.glsl"

#include "shaders/shared/storage.glsl"
#include "shaders/shared/textbook.glsl"
#pragma GCC diagnostic pop
}  // namespace g

g::Moments to_shared(const MomentVector& vector) {
    g::Moments moments;
    moments.b0 = vector.b0;
    std::copy_n(vector.b.begin(), MOMENT_FLOATS, moments.b);
    return moments;
}

g::Basis basis_of(const ReconstructionSettings& settings) {
#ifdef NESTED_ORDERS
    return g::make_basis(settings.tolerance);
#else
    return g::make_basis(settings.wrapping_zone_angle);
#endif
}

g::Moments unpacked(const MomentVector& stored) {
    return g::unpacked_moments(to_shared(stored));
}

void evaluate_wide(const g::Factor& factor, const g::Basis& basis, float b0, float overestimation,
                   const float* __restrict depths, std::size_t count, float* __restrict reconstructed,
                   float* __restrict beta0, float* __restrict beta1) {
    for (std::size_t i = 0; i < count; ++i) {
        const g::Reconstruction at_depth = g::reconstruct(factor, basis, depths[i]);
        reconstructed[i] = g::absorbance_in_front(at_depth, b0, overestimation);
        beta0[i] = g::absorbance_in_front(at_depth, b0, 0.0f);
        beta1[i] = g::absorbance_in_front(at_depth, b0, 1.0f);
    }
}

#if defined(ALGORITHM_1) || defined(ALGORITHM_2)
constexpr bool HAS_TEXTBOOK = true;

float textbook(const g::Moments& moments, const ReconstructionSettings& settings, float overestimation,
               float depth) {
    return g::textbook_fraction(moments, depth, settings.bias, overestimation, basis_of(settings));
}
#else
constexpr bool HAS_TEXTBOOK = false;

float textbook(const g::Moments&, const ReconstructionSettings&, float, float) {
    return 0;
}
#endif

// The published algorithm handles one depth at a time.
void evaluate_textbook(const g::Moments& moments, const ReconstructionSettings& settings,
                       std::span<const float> depths, const AbsorbanceCurves& curves) {
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto absorbance = [&](float beta) {
            return moments.b0 * g::number_in_unit_range(textbook(moments, settings, beta, depths[i]));
        };
        curves.reconstructed[i] = absorbance(settings.overestimation);
        curves.beta0[i] = absorbance(0.0f);
        curves.beta1[i] = absorbance(1.0f);
    }
}

bool is_published(const ReconstructionSettings& settings) {
    return settings.estimate == Estimate::beta && settings.ends == RayEnds::off &&
           settings.interval == MomentInterval::scene;
}

void evaluate(const MomentVector& vector, const ReconstructionSettings& settings,
              std::span<const float> depths, const AbsorbanceCurves& curves) {
    const g::Moments moments = unpacked(vector);
    if (g::is_empty(moments)) {
        for (const auto& curve : {curves.reconstructed, curves.beta0, curves.beta1})
            std::ranges::fill(curve, 0.0f);
        return;
    }
    if (settings.solver == Solver::textbook) return evaluate_textbook(moments, settings, depths, curves);
    if (!is_published(settings)) return any_cpu::evaluate_estimates(vector, settings, depths, curves);
    const g::Basis basis = basis_of(settings);
    const g::Factor factor = g::factor_moments(g::biased_moments(moments, settings.bias));
    evaluate_wide(factor, basis, vector.b0, settings.overestimation, depths.data(), depths.size(),
                  curves.reconstructed.data(), curves.beta0.data(), curves.beta1.data());
}

float fraction(const MomentVector& vector, const ReconstructionSettings& settings, float depth) {
    const g::Moments moments = unpacked(vector);
    if (g::is_empty(moments)) return 0;
    if (settings.solver == Solver::textbook)
        return textbook(moments, settings, settings.overestimation, depth);
    if (settings.interval == MomentInterval::pixel)
        return any_cpu::fraction_of_pixel(vector, settings, depth);
    const g::Basis basis = basis_of(settings);
    const g::Factor factor = g::factor_moments(g::biased_moments(moments, settings.bias));
    return g::fraction_in_front(g::reconstruct(factor, basis, depth), settings.overestimation);
}

constexpr std::size_t BATCH = 64;  // pixels; so few that their moments stay in the first-level cache

/// Number k of pixel i is at k BATCH + i: b_0, then the other moments.
using MomentColumns = std::array<float, (MOMENT_FLOATS + 1) * BATCH>;

void fractions_wide(const MomentColumns& columns, const float* __restrict depths, std::size_t count,
                    const g::Basis& basis, float bias, float overestimation, float* __restrict fractions) {
    for (std::size_t i = 0; i < count; ++i) {
        g::Moments stored;
        stored.b0 = columns[i];
        for (std::size_t k = 0; k < MOMENT_FLOATS; ++k) stored.b[k] = columns[(k + 1) * BATCH + i];
        const g::Moments moments = g::unpacked_moments(stored);
        const g::Factor factor = g::factor_moments(g::biased_moments(moments, bias));
        const float fraction = g::fraction_in_front(g::reconstruct(factor, basis, depths[i]), overestimation);
        fractions[i] = g::is_empty(moments) ? 0.0f : fraction;
    }
}

void fractions(std::span<const MomentVector> vectors, const ReconstructionSettings& settings,
               std::span<const float> depths, std::span<float> results) {
    if (settings.solver == Solver::textbook || settings.interval == MomentInterval::pixel) {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            results[i] = fraction(vectors[i], settings, depths[i]);
        return;
    }
    const g::Basis basis = basis_of(settings);
    MomentColumns columns{};
    for (std::size_t first = 0; first < vectors.size(); first += BATCH) {
        const std::size_t count = std::min(BATCH, vectors.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            columns[i] = vectors[first + i].b0;
            for (std::size_t k = 0; k < MOMENT_FLOATS; ++k)
                columns[(k + 1) * BATCH + i] = vectors[first + i].b[k];
        }
        fractions_wide(columns, &depths[first], count, basis, settings.bias, settings.overestimation,
                       &results[first]);
    }
}
