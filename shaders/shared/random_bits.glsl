// random_bits.glsl -- pseudorandom numbers that depend only on where they are used. So they are the same in every pass, on every
// GPU and in C++.

/// Spreads all bits of x over all bits of the result. This is a permutation; Wellons 2018 found the multipliers.
FN uint mixed_bits(uint x)
{
    uint bits = x ^ (x >> 16);
    bits = bits * 0x7feb352du;
    bits = bits ^ (bits >> 15);
    bits = bits * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

/// Bits that belong to one fragment, whatever the order of submission. pixel: x + 65536 y. depth_bits: the bits of its view depth.
FN uint fragment_seed(uint pixel, uint object, uint depth_bits)
{
    return mixed_bits(depth_bits + mixed_bits(object + mixed_bits(pixel + 0x9e3779b9u)));
}

/// The i-th random number of a seed, in [0, 1). It is a multiple of 2^-24.
FN float unit_random(uint seed, int i)
{
    return float(mixed_bits(seed + uint(i) * 0x9e3779b9u) >> 8) * 5.96046448e-8f;
}
