// textbook.glsl -- Algorithms 1 and 2 as they are published, for the bases that they know. Follows the basis.
#if defined(ALGORITHM_1)
#include "textbook_power.glsl"
#elif defined(ALGORITHM_2)
#include "textbook_trigonometric.glsl"
#endif
