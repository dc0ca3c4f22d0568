// opaque_kernel.hpp -- the math file of a row of opaque_shadows.def as C++ functions.
#pragma once
#include "core/shadow/opaque_shadow.hpp"

namespace momentscope {

struct OpaqueKernel {
    ShadowTexel (*texel)(float depth);
    float (*shadowed)(const ShadowTexel& texel, float depth);
    bool unfiltered;
    float bias;
    float theta;
};

enum class OpaqueShadowId {
#define OPAQUE_SHADOW(id, ...) id,
#include "core/shadow/opaque_shadows.def"
#undef OPAQUE_SHADOW
};

/// Defined in the file that CMake generates for each row.
template <OpaqueShadowId Id>
OpaqueKernel opaque_kernel();

#define OPAQUE_SHADOW(id, ...) \
    template <>                \
    OpaqueKernel opaque_kernel<OpaqueShadowId::id>();
#include "core/shadow/opaque_shadows.def"
#undef OPAQUE_SHADOW

}  // namespace momentscope
