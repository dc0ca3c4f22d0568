// pixel_state_techniques.hpp -- the ids of pixel_state_techniques.def in C++, and the kernel of each
// technique.
#pragma once

namespace momentscope {

struct PixelStateKernel;

enum class PixelStateTechnique {
#define PIXEL_STATE_TECHNIQUE(id, ...) id,
#include "core/techniques/pixel_state_techniques.def"
#undef PIXEL_STATE_TECHNIQUE
};

template <PixelStateTechnique>
struct PixelStateKernelTag {};

#define PIXEL_STATE_TECHNIQUE(id, ...) \
    const PixelStateKernel& pixel_state_kernel(PixelStateKernelTag<PixelStateTechnique::id>);
#include "core/techniques/pixel_state_techniques.def"
#undef PIXEL_STATE_TECHNIQUE

}  // namespace momentscope
