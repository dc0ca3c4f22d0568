// rounding_check.frag -- the sum and the product of two numbers with their rounding errors. A driver that re-associates gives 0 for
// these errors (core/gl/rounding_check.hpp).
#include "shared/float_pair.glsl"

uniform int first_bits;
uniform int second_bits;

layout(location = 0) out vec4 results;

void main()
{
    float a = intBitsToFloat(first_bits);
    float b = intBitsToFloat(second_bits);
    FloatPair sum = exact_sum(a, b);
    FloatPair product = exact_product(a, b);
    results = vec4(sum.high, sum.low, product.high, product.low);
}
