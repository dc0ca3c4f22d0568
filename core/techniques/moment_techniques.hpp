// moment_techniques.hpp -- the ids of moment_techniques.def in C++, and the kernel of each technique.
#pragma once

namespace momentscope {

struct MomentKernel;

enum class MomentTechnique {
#define MOMENT_TECHNIQUE(id, ...) id,
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
};

template <MomentTechnique>
struct MomentKernelTag {};

#define MOMENT_TECHNIQUE(id, ...) const MomentKernel& moment_kernel(MomentKernelTag<MomentTechnique::id>);
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE

}  // namespace momentscope
