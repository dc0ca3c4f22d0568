// prelude.glsl -- the words of the shared subset as GLSL. core/gl/dialect.cpp has those that differ between dialects, and
// core/support/glsl.hpp defines all of them for C++.
#define FN
#define IN(T) const in T
#define UNROLL
