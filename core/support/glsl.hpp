// glsl.hpp -- the words and built-in functions with which shaders/shared/*.glsl compiles as C++.
//
// A shared file is GLSL within the limits of docs/glsl-subset.md, plus four words. shaders/prelude.glsl and
// core/gl/dialect.cpp define them for GLSL:
//   FN       before every function; always inlined in C++, so that it is compiled for the instruction set of
//            the loop that calls it
//   IN(T)    a parameter that is only read
//   PRECISE  before a local variable whose rounding must not be re-associated; nothing in C++, which is
//            compiled with -ffp-contract=off
//   UNROLL   before a loop of fixed count
// Include shared files inside a namespace nested in momentscope::glsl.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#define FN [[gnu::always_inline]] inline
#define IN(T) const T&
#define PRECISE
#if defined(__clang__)
#define UNROLL _Pragma("clang loop unroll(full)")
#else
#define UNROLL _Pragma("GCC unroll 8")
#endif

namespace momentscope::glsl {

using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
using std::cos;
using std::floor;
using std::pow;
using std::sin;
using std::sqrt;

// Scalars only and no templates, so that calls such as min(x, 0.0f) mean the same as in GLSL.
inline float abs(float x) {
    return std::fabs(x);
}
inline float min(float a, float b) {
    return b < a ? b : a;
}
inline float max(float a, float b) {
    return a < b ? b : a;
}
inline int min(int a, int b) {
    return b < a ? b : a;
}
inline int max(int a, int b) {
    return a < b ? b : a;
}
inline float clamp(float x, float low, float high) {
    return min(max(x, low), high);
}
inline float atan(float y, float x) {
    return std::atan2(y, x);
}
[[gnu::always_inline]] inline float fma(float a, float b, float c) {
    return __builtin_fmaf(a, b, c);
}
inline int floatBitsToInt(float x) {
    return std::bit_cast<int>(x);
}
inline float intBitsToFloat(int bits) {
    return std::bit_cast<float>(bits);
}

}  // namespace momentscope::glsl
