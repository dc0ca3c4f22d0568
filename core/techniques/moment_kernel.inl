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
#include "core/techniques/moment_kernel_functions.inl"
}

#ifdef INSTRUCTION_SETS
#define FUSED_MULTIPLY_ADD  // see float_pair.glsl
#pragma GCC push_options
#pragma GCC target("arch=x86-64-v3")
namespace avx2 {
#include "core/techniques/moment_kernel_functions.inl"
}
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("arch=x86-64-v4")
namespace avx512 {
#include "core/techniques/moment_kernel_functions.inl"
}
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
