// nested_moments.glsl -- Chebyshev moments of which every fragment is reconstructed with as few as it needs. MOMENT_COUNT is
// 8. Not in the papers; docs/adaptive.md explains it.

#define NESTED_ORDERS   // reconstruction.glsl
#include "chebyshev_moments.glsl"
