// nonlinear_quantisation.glsl -- non-linearly quantised moments (Peters 2017). Four power moments are stored as two depths, the
// weight of the second, and an offset. The two depths with their weights have the first three moments. The offset is the amount by
// which the fourth moment exceeds theirs. Rounding harms these numbers less than moments.

/// Mass 1 - weight at `near` and mass weight at `far`. offset: how much b_4 exceeds the fourth moment of these two masses. All for
/// moments with b_0 = 1.
struct TwoDepths { float near; float far; float weight; float offset; };

const float MIN_OFFSET = 1.2e-7f;
const float OFFSET_UNIT = 1.0e-7f;
const float WARP_LOW = -1.7019834f;    // ln ln 1.2
const float WARP_HIGH = 2.6900085f;    // ln ln(0.25 / 1e-7)

/// b1 to b4: biased moments, normalised to b_0 = 1.
///
/// `near` and `far` are the roots of the orthogonal polynomial p_2 = z^2 + p z + q. E[p_2] = 0 and E[z p_2] = 0 give
/// p = (b_1 b_2 - b_3) / (b_2 - b_1^2) and q = -b_2 - p b_1. The two weights have the mean b_1. The offset is
/// h_2 = E[p_2^2] = b_4 + p b_3 + q b_2, because E[p_2^2] is 0 for the two masses themselves.
FN TwoDepths two_depths(float b1, float b2, float b3, float b4)
{
    PRECISE float variance = max(b2 - b1 * b1, 1.0e-12f);
    PRECISE float covariance = b1 * b2 - b3;
    PRECISE float p0 = -(b1 * covariance + b2 * variance);
    PRECISE float p = covariance / variance;
    PRECISE float q = p0 / variance;
    PRECISE float square = max(p * p * 0.25f - q, 0.0f);
    PRECISE float root = sqrt(square);
    TwoDepths result;
    result.near = -0.5f * p - root;
    result.far = -0.5f * p + root;
    result.weight = clamp((b1 - result.near) / max(result.far - result.near, 1.0e-12f), 0.0f, 1.0f);
    PRECISE float offset = (b4 - b2 * b2) - covariance * covariance / variance;
    result.offset = offset;
    return result;
}

/// Maps an offset to [0, 1]. Offsets span seven decades and most are small, so their double logarithm is stored.
FN float warped_offset(float offset)
{
    float bounded = clamp(offset, MIN_OFFSET, 0.25f);
    return (portable_log(portable_log(bounded / OFFSET_UNIT)) - WARP_LOW) / (WARP_HIGH - WARP_LOW);
}

FN float unwarped_offset(float warped)
{
    return portable_exp(portable_exp(warped * (WARP_HIGH - WARP_LOW) + WARP_LOW)) * OFFSET_UNIT;
}

/// The numbers as 64 bits hold them: 16 bits each, converted back.
FN TwoDepths rounded_to_64_bits(IN(TwoDepths) exact)
{
    TwoDepths result;
    result.near = 2.0f * rounded_to_unorm16(0.5f * exact.near + 0.5f) - 1.0f;
    result.far = 2.0f * rounded_to_unorm16(0.5f * exact.far + 0.5f) - 1.0f;
    result.weight = rounded_to_unorm16(exact.weight);
    result.offset = unwarped_offset(rounded_to_unorm16(warped_offset(exact.offset)));
    return result;
}

/// The depth rounded to the middle of one of 1023 cells.
FN float rounded_depth(float depth)
{
    PRECISE float code = floor(clamp(depth, -1.0f, 0.999f) * 511.5f + 511.5f);
    return (code + 0.5f) / 511.5f - 1.0f;
}

/// The numbers as 32 bits hold them, converted back to the middles of cells. Each depth takes 10 bits (the order of the two spares
/// one bit), the square root of the weight 7 and the offset 6.
FN TwoDepths rounded_to_32_bits(IN(TwoDepths) exact)
{
    TwoDepths result;
    result.near = rounded_depth(exact.near);
    result.far = rounded_depth(exact.far);
    float root = min(floor(sqrt(clamp(exact.weight, 0.0f, 1.0f)) * 128.0f), 127.0f) / 128.0f + 1.0f / 256.0f;
    result.weight = root * root;
    float code = clamp(floor(warped_offset(exact.offset) * 64.0f), 0.0f, 63.0f);
    result.offset = unwarped_offset(code / 64.0f + 1.0f / 128.0f);
    return result;
}

/// The mass that the canonical representation with a node at r has there: 1 / K(r, r). Depths are in units of the distance between
/// the two depths, with `near` at 0 and `far` at 1. For masses 1 - w at 0 and w at 1, the terms of K for p_0 and p_1 sum to
/// (1 - r)^2 / (1 - w) + r^2 / w. The term for p_2 = r (r - 1) with h_2 = offset is (r (r - 1))^2 / offset.
FN float mass_at(float r, float inverse_near, float inverse_far, float offset)
{
    PRECISE float s = (1.0f - r) * (1.0f - r);
    PRECISE float denominator = inverse_near * s + inverse_far * r * r + r * r * s / offset;
    return 1.0f / denominator;
}

/// A(z_f) / b_0 of Algorithm 1 in closed form (Peters 2017). overestimation: the share of the mass at the query depth that counts
/// as in front of it.
FN float fraction_of_two_depths(IN(TwoDepths) quantised, float depth, float overestimation)
{
    float weight = clamp(quantised.weight, 5.0e-6f, 1.0f - 5.0e-6f);
    float far = max(quantised.far, quantised.near + 5.0e-6f);
    PRECISE float scale = 1.0f / (far - quantised.near);
    PRECISE float n = (depth - quantised.near) * scale;
    PRECISE float squared = scale * scale;
    PRECISE float offset = max(quantised.offset, MIN_OFFSET) * squared * squared;
    float inverse_near = 1.0f / (1.0f - weight);
    float inverse_far = 1.0f / weight;
    float own = mass_at(n, inverse_near, inverse_far, offset);
    float in_front = 0.0f;
    if (n >= 1.0f) in_front = 1.0f - own;
    else if (n > 0.0f)
    {
        // The two other nodes are the roots of K(n, r) = 0, which is r^2 + 2 half_p r + q = 0. Their product q is negative; the
        // root r < 0 is the node in front.
        PRECISE float q = -offset * inverse_near / n;
        PRECISE float half_p = -0.5f * q * (1.0f - n * inverse_far) / (1.0f - n) - 0.5f;
        PRECISE float square = max(half_p * half_p - q, 0.0f);
        PRECISE float root = sqrt(square);
        PRECISE float r = half_p > 0.0f ? -half_p - root : q / max(root - half_p, 1.0e-30f);   // the form in which nothing cancels
        in_front = mass_at(r, inverse_near, inverse_far, offset);
    }
    return in_front + overestimation * own;
}
