// method_techniques.hpp -- the ids of method_techniques.def in C++, and the kernel compiled for each.
#pragma once

namespace momentscope {

struct MethodKernel;

enum class MethodTechnique {
#define METHOD_TECHNIQUE(id, ...) id,
#include "core/techniques/method_techniques.def"
#undef METHOD_TECHNIQUE
};

template <MethodTechnique>
struct MethodKernelTag {};

#define METHOD_TECHNIQUE(id, ...) const MethodKernel& method_kernel(MethodKernelTag<MethodTechnique::id>);
#include "core/techniques/method_techniques.def"
#undef METHOD_TECHNIQUE

}  // namespace momentscope
