// rounding_check.frag -- left texel: the sum and the product of two numbers with their rounding errors. A driver that re-associates
// gives 0 for these errors (core/gl/rounding_check.hpp). Right texel: sums and products with two constants. Some drivers keep the
// former, but add or multiply the constants first.
#include "shared/float_pair.glsl"

uniform int first_bits;
uniform int second_bits;

layout(location = 0) out vec4 results;

vec4 with_constants(float a, float b)
{
    PRECISE float shifted = (a - 1.57079637f) + 4.37113883e-8f;
    PRECISE float scaled = (b * 3.14159274f) * 1.44269502f;
    PRECISE float polynomial = a * (-0.5f + a * (4.16666679e-2f + a * -1.38888892e-3f));
    return vec4(shifted, scaled, polynomial, 1.0f);
}

void main()
{
    float a = intBitsToFloat(first_bits);
    float b = intBitsToFloat(second_bits);
    if (gl_FragCoord.x > 1.0)
    {
        results = with_constants(a, b);
        return;
    }
    FloatPair sum = exact_sum(a, b);
    FloatPair product = exact_product(a, b);
    results = vec4(sum.high, sum.low, product.high, product.low);
}
