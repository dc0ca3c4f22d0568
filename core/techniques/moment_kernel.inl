// moment_kernel.inl -- the body of a MomentKernel. A file that CMake generates from moment_kernel.cpp.in
// defines KERNEL_ID, MOMENT_COUNT, MOMENT_BITS and MOMENT_BASIS (a file of shaders/shared) and includes this
// file.
//
// The functions are compiled for each instruction set that makes them faster. At run time the best one that
// the CPU has is chosen. Results are the same in every bit.
#include "core/support/glsl.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"
#include "core/techniques/quantisation.hpp"

#include <algorithm>
#include <array>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(MOMENTSCOPE_SANITIZE) && \
    !defined(MOMENTSCOPE_ONE_INSTRUCTION_SET)
#define INSTRUCTION_SETS
#endif

namespace momentscope {
namespace glsl::KERNEL_ID {
namespace {

namespace any_cpu {
// moment_kernel_estimates.inl
void evaluate_estimates(const MomentVector& vector, const ReconstructionSettings& settings,
                        std::span<const float> depths, const AbsorbanceCurves& curves);
float fraction_of_pixel(const MomentVector& vector, const ReconstructionSettings& settings, float depth);

#include "core/techniques/moment_kernel_functions.inl"

#include "core/techniques/moment_kernel_estimates.inl"
}  // namespace any_cpu

#ifdef INSTRUCTION_SETS
/// The kernel with functions of a wider instruction set.
constexpr MomentKernel with_functions(MomentKernel kernel, decltype(kernel.evaluate) evaluate,
                                      decltype(kernel.fraction) fraction,
                                      decltype(kernel.fractions) fractions) {
    kernel.evaluate = evaluate;
    kernel.fraction = fraction;
    kernel.fractions = fractions;
    return kernel;
}

#define FUSED_MULTIPLY_ADD  // see float_pair.glsl
#pragma GCC push_options
#pragma GCC target("arch=x86-64-v3")
namespace avx2 {
#include "core/techniques/moment_kernel_functions.inl"
constexpr MomentKernel KERNEL = with_functions(any_cpu::KERNEL, evaluate, fraction, fractions);
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("arch=x86-64-v4")
namespace avx512 {
#include "core/techniques/moment_kernel_functions.inl"
constexpr MomentKernel KERNEL = with_functions(any_cpu::KERNEL, evaluate, fraction, fractions);
}  // namespace avx512
#pragma GCC pop_options
#endif

const MomentKernel& fastest() {
#ifdef INSTRUCTION_SETS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("x86-64-v4")) return avx512::KERNEL;
    if (__builtin_cpu_supports("x86-64-v3")) return avx2::KERNEL;
#endif
    return any_cpu::KERNEL;
}

}  // namespace
}  // namespace glsl::KERNEL_ID

const MomentKernel& moment_kernel(MomentKernelTag<MomentTechnique::KERNEL_ID>) {
    static const MomentKernel& kernel = glsl::KERNEL_ID::fastest();
    return kernel;
}

}  // namespace momentscope
