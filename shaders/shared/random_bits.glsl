// random_bits.glsl -- numbers that look random and are a function of where they are asked for: the same in every pass, on
// every GPU and in C++.

/// All bits of x spread over all bits of the result (a permutation; multipliers found by Wellons 2018).
FN uint mixed_bits(uint x)
{
    uint bits = x ^ (x >> 16);
    bits = bits * 0x7feb352du;
    bits = bits ^ (bits >> 15);
    bits = bits * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

/// A fragment's own bits, whatever the order in which it is submitted. pixel: x + 65536 y; depth_bits: those of its view depth.
FN uint fragment_seed(uint pixel, uint object, uint depth_bits)
{
    return mixed_bits(depth_bits + mixed_bits(object + mixed_bits(pixel + 0x9e3779b9u)));
}

/// The i-th number in [0, 1) of a seed, a multiple of 2^-24.
FN float unit_random(uint seed, int i)
{
    return float(mixed_bits(seed + uint(i) * 0x9e3779b9u) >> 8) * 5.96046448e-8f;
}
