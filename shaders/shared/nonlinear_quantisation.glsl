// nonlinear_quantisation.glsl -- non-linearly quantised moments (Peters 2017): four power moments as the two depths and the weight
// that have the first three of them, and how far the fourth exceeds theirs, which round more kindly than moments.

/// Mass 1 - weight at `near` and weight at `far`; offset is what b_4 has beyond these two. All of moments with b_0 = 1.
struct TwoDepths { float near; float far; float weight; float offset; };

const float MIN_OFFSET = 1.2e-7f;
const float OFFSET_UNIT = 1.0e-7f;
const float WARP_LOW = -1.7019834f;    // ln ln 1.2
const float WARP_HIGH = 2.6900085f;    // ln ln(.25 / 1e-7)

/// b: biased moments b_1 ... b_4, normalised.
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

/// Offsets span seven decades, most of them small: ln ln makes a unit range of them.
FN float warped_offset(float offset)
{
    float bounded = clamp(offset, MIN_OFFSET, 0.25f);
    return (portable_log(portable_log(bounded / OFFSET_UNIT)) - WARP_LOW) / (WARP_HIGH - WARP_LOW);
}

FN float unwarped_offset(float warped)
{
    return portable_exp(portable_exp(warped * (WARP_HIGH - WARP_LOW) + WARP_LOW)) * OFFSET_UNIT;
}

/// What 64 bits hold: four numbers of 16 bits, which are returned as they are read.
FN TwoDepths rounded_to_64_bits(IN(TwoDepths) exact)
{
    TwoDepths result;
    result.near = 2.0f * rounded_to_unorm16(0.5f * exact.near + 0.5f) - 1.0f;
    result.far = 2.0f * rounded_to_unorm16(0.5f * exact.far + 0.5f) - 1.0f;
    result.weight = rounded_to_unorm16(exact.weight);
    result.offset = unwarped_offset(rounded_to_unorm16(warped_offset(exact.offset)));
    return result;
}

/// The middle of one of 1023 cells of depth.
FN float rounded_depth(float depth)
{
    PRECISE float code = floor(clamp(depth, -1.0f, 0.999f) * 511.5f + 511.5f);
    return (code + 0.5f) / 511.5f - 1.0f;
}

/// What 32 bits hold, read back as the middles of cells: 10 bits for each depth (one of which the order of the two spares), 7 for the root of the weight, 6 for
/// the offset.
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

/// Mass at r of the distribution that has mass at 0, 1 and r, in units of the distance between the two depths.
FN float mass_at(float r, float inverse_near, float inverse_far, float offset)
{
    PRECISE float s = (1.0f - r) * (1.0f - r);
    PRECISE float denominator = inverse_near * s + inverse_far * r * r + r * r * s / offset;
    return 1.0f / denominator;
}

/// A(z_f) / b_0 of Algorithm 1 in closed form (Peters 2017). overestimation: the share of the mass at the query depth that counts
/// as in front.
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
        // The canonical representation has two other nodes, of which r < 0 is in front.
        PRECISE float q = -offset * inverse_near / n;
        PRECISE float half_p = -0.5f * q * (1.0f - n * inverse_far) / (1.0f - n) - 0.5f;
        PRECISE float square = max(half_p * half_p - q, 0.0f);
        PRECISE float root = sqrt(square);
        PRECISE float r = half_p > 0.0f ? -half_p - root : q / max(root - half_p, 1.0e-30f);   // nothing cancels
        in_front = mass_at(r, inverse_near, inverse_far, offset);
    }
    return in_front + overestimation * own;
}
