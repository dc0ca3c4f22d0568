// nested_moments.glsl -- Chebyshev moments with an adaptive order: each fragment is reconstructed from as few moments as it needs.
// MOMENT_COUNT is 8. Not in the papers; docs/adaptive.md explains it.

#define NESTED_ORDERS   // see reconstruction.glsl
#include "chebyshev_moments.glsl"
