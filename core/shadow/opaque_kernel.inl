// opaque_kernel.inl -- the body of an OpaqueKernel. A file that CMake generates from opaque_kernel.cpp.in
// defines KERNEL_ID, SHADOW_FILE (a file of shaders/shared), MOMENT_COUNT and MOMENT_BITS, and includes this
// file.
#include "core/shadow/opaque_kernel.hpp"
#include "core/support/glsl.hpp"
#include "core/techniques/quantisation.hpp"

#include <algorithm>

namespace momentscope {
namespace glsl::shadow::KERNEL_ID {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // all rows have the same signatures
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
#if MOMENT_BITS == 16
constexpr auto THETA_ODD = flat_floats(quantisation_transform<MOMENT_COUNT>().odd);
constexpr auto THETA_EVEN = flat_floats(quantisation_transform<MOMENT_COUNT>().even);
constexpr auto THETA_ODD_INVERSE = flat_floats(inverse(quantisation_transform<MOMENT_COUNT>().odd));
constexpr auto THETA_EVEN_INVERSE = flat_floats(inverse(quantisation_transform<MOMENT_COUNT>().even));
constexpr auto THETA_EVEN_OFFSET = floats(quantisation_transform<MOMENT_COUNT>().even_offset);
#endif
#include SHADOW_FILE
#pragma GCC diagnostic pop
}  // namespace glsl::shadow::KERNEL_ID

namespace {

namespace g = glsl::shadow::KERNEL_ID;

ShadowTexel texel(float depth) {
    ShadowTexel result;
    std::copy_n(g::shadow_texel(depth).f, result.size(), result.begin());
    return result;
}

float shadowed(const ShadowTexel& stored, float depth) {
    return g::shadowed_fraction(g::make_shadow_texel(stored[0], stored[1], stored[2], stored[3]), depth);
}

#ifdef UNFILTERED
constexpr bool IS_UNFILTERED = true;
#else
constexpr bool IS_UNFILTERED = false;
#endif

}  // namespace

template <>
OpaqueKernel opaque_kernel<OpaqueShadowId::KERNEL_ID>() {
#if MOMENT_COUNT > 0
    return {texel, shadowed, IS_UNFILTERED, g::SHADOW_BIAS, g::SHADOW_PARAMETER};
#else
    return {texel, shadowed, IS_UNFILTERED, 0, 0};
#endif
}

}  // namespace momentscope
