// evaluate.frag -- evaluates one item per pixel of a picture that is 512 pixels wide.
#include "tests/evaluate.glsl"

void main()
{
    evaluate(uint(gl_FragCoord.y) * 512u + uint(gl_FragCoord.x));
}
