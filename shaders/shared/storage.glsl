// storage.glsl -- how a pixel stores its moments. MOMENT_BITS is 32 or 16. Include it after the basis.
#if MOMENT_BITS == 16
#include "unorm16_storage.glsl"
#else
#include "float_storage.glsl"
#endif
