// count.frag -- counts the fragments of a pixel, by additive blending.
layout(location = 0) out vec4 one;

void main()
{
    one = vec4(1.0);
}
