// renormalization.glsl -- how far uncertain weights are moved so that all weights sum to the coverage.

/// The share of their spreads by which all weights are moved, in [-1, 1]. weights: their sum. spreads: the sum of their spreads,
/// >= 0. coverage: 1 - exp(-b_0), which the weights should sum to.
FN float moved_share(float weights, float spreads, float coverage)
{
    return spreads > 0.0f ? clamp((coverage - weights) / spreads, -1.0f, 1.0f) : 0.0f;
}
