// textbook.glsl -- Algorithms 1 and 2 as published, for the bases that have one. Include it after the basis.
#if defined(ALGORITHM_1)
#include "textbook_power.glsl"
#elif defined(ALGORITHM_2)
#include "textbook_trigonometric.glsl"
#endif
