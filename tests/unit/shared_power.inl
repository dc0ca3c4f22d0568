// shared_power.inl -- shaders/shared/power_moments.glsl in a namespace of its own: define SHARED_NAME,
// MOMENT_COUNT and MOMENT_BITS before.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"     // the shape is the same for every basis
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 cannot follow triangular loops
namespace momentscope::glsl::SHARED_NAME {
#include "shaders/shared/portable_math.glsl"
// portable_math first
#include "shaders/shared/power_moments.glsl"
}  // namespace momentscope::glsl::SHARED_NAME
#pragma GCC diagnostic pop
#undef SHARED_NAME
#undef MOMENT_COUNT
#undef MOMENT_BITS
#undef THETA_TRANSFORM
