#include "tests/evaluate.glsl"

layout(local_size_x = 64) in;

void main()
{
    evaluate(gl_GlobalInvocationID.x);
}
