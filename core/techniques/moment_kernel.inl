// moment_kernel.inl -- the body of a MomentKernel. A file generated from moment_kernel.cpp.in defines
// KERNEL_ID, MOMENT_COUNT and MOMENT_BASIS (a file of shaders/shared) and includes this.
#include "core/glsl.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(MOMENTSCOPE_SANITIZE) && \
    !defined(MOMENTSCOPE_NO_CLONES)
#define WIDE_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define WIDE_CLONES
#endif

namespace momentscope {
namespace glsl::KERNEL_ID {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // the shape is the same for every basis
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 cannot follow the triangular loops
#include "shaders/shared/portable_math.glsl"
#include MOMENT_BASIS
#include "shaders/shared/reconstruction.glsl"
#pragma GCC diagnostic pop
}  // namespace glsl::KERNEL_ID

namespace {

namespace g = glsl::KERNEL_ID;

g::Moments to_shared(const MomentVector& vector) {
    g::Moments moments;
    moments.b0 = vector.b0;
    std::copy_n(vector.b.begin(), MOMENT_FLOATS, moments.b);
    return moments;
}

void add_fragment(MomentVector& sum, float depth, float absorbance, float wrapping_zone_angle) {
    const g::Moments added = g::fragment_moments(depth, absorbance, g::make_basis(wrapping_zone_angle));
    sum.b0 += added.b0;
    for (std::size_t i = 0; i < MOMENT_FLOATS; ++i) sum.b[i] += added.b[i];
}

WIDE_CLONES
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

void evaluate(const MomentVector& vector, const ReconstructionSettings& settings,
              std::span<const float> depths, const AbsorbanceCurves& curves) {
    if (g::is_empty(to_shared(vector))) {
        for (const auto& curve : {curves.reconstructed, curves.beta0, curves.beta1})
            std::ranges::fill(curve, 0.0f);
        return;
    }
    const g::Basis basis = g::make_basis(settings.wrapping_zone_angle);
    const g::Factor factor = g::factor_moments(g::biased_moments(to_shared(vector), settings.bias));
    evaluate_wide(factor, basis, vector.b0, settings.overestimation, depths.data(), depths.size(),
                  curves.reconstructed.data(), curves.beta0.data(), curves.beta1.data());
}

ReconstructionSteps steps(const MomentVector& vector, const ReconstructionSettings& settings, float depth) {
    ReconstructionSteps result;
    if (g::is_empty(to_shared(vector))) return result;
    const g::Basis basis = g::make_basis(settings.wrapping_zone_angle);
    const g::BiasedMoments biased = g::biased_moments(to_shared(vector), settings.bias);
    const g::Factor factor = g::factor_moments(biased);
    const g::Kernel kernel = g::kernel_polynomial(g::query_at(depth, factor, basis), factor);
    const g::Reconstruction at_depth = g::reconstruct(factor, basis, depth);
    result.biased.b0 = 1;
    for (std::size_t i = 0; i < MOMENT_FLOATS; ++i)
        result.biased.b[i] = (biased.b[i] + biased.pull[i]) / biased.b0;
    result.floored_pivots = factor.floored;
    result.query_weight = at_depth.query_weight;
    result.in_front = at_depth.in_front;
    result.kernel[0] = kernel.at_query;
    std::copy_n(kernel.in_t.e, ROOT_COUNT, result.kernel.begin() + 1);
    std::copy_n(at_depth.t, ROOT_COUNT, result.t.begin());
    std::copy_n(at_depth.weight, ROOT_COUNT, result.weight.begin());
    std::copy_n(at_depth.value, ROOT_COUNT, result.value.begin());
    result.absorbance = g::absorbance_in_front(at_depth, vector.b0, settings.overestimation);
    return result;
}

}  // namespace

const MomentKernel& moment_kernel(MomentKernelTag<MomentTechnique::KERNEL_ID>) {
    static constexpr MomentKernel kernel = {MOMENT_FLOATS, ROOT_COUNT, add_fragment, evaluate, steps};
    return kernel;
}

}  // namespace momentscope
