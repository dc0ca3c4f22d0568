// prelude.glsl -- the words of the shared subset for a GL driver; core/glsl.hpp is their C++ face.
#define FN
#define IN(T) const in T
#define PRECISE precise
#define UNROLL
