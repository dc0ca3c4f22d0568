// prelude.glsl -- the words of the shared subset as GLSL. core/support/glsl.hpp defines them for C++.
#define FN
#define IN(T) const in T
#define PRECISE precise
#define UNROLL
