// wavelet.glsl -- wavelet opacity (Aizenshtein, Smal and McGuire 2022). The absorbance as a function of depth is stored in Haar
// wavelets of rank R = 3, with 2^(R+1) = 16 coefficients. No settings.
#define MAX_STATE_FLOATS 16
#define STATE_SUMS
#include "pixel_state.glsl"

const int WAVELET_RANK = 3;
const int COEFFICIENTS = 16;

FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    return zero_state();
}

/// 2^(level/2), for levels 0 to 3.
FN float level_scale(int level)
{
    float odd = level % 2 == 1 ? 1.41421356f : 1.0f;
    return level >= 2 ? 2.0f * odd : odd;
}

/// The depth, scaled so that the greatest depth lies within the last of the 16 cells.
FN float cell_depth(float depth)
{
    return clamp(depth, 0.0f, 1.0f) * (15.0f / 16.0f);
}

/// Integrals of the step function of the fragment against every wavelet. The last number belongs to the scaling function.
FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    float absorbance = absorbance_of_opacity(fragment.opacity);
    float depth = cell_depth(fragment.depth);
    state.f[COEFFICIENTS - 1] = absorbance * (1.0f - depth);
    UNROLL
    for (int node = 0; node < COEFFICIENTS - 1; ++node)
    {
        int level = node >= 7 ? 3 : (node >= 3 ? 2 : (node >= 1 ? 1 : 0));
        float cells = float(1 << level);
        PRECISE float place = depth * cells - float(node + 1 - (1 << level));   // in [0, 1) within the interval of the node
        float height = place < 0.5f ? place : 1.0f - place;
        float within = place >= 0.0f && place < 1.0f ? height : 0.0f;
        state.f[node] = absorbance * level_scale(level) * within / cells;
    }
    return state;
}

/// The mean of A over the cell `leaf`, one of 16.
FN float mean_absorbance(IN(PixelState) state, int leaf)
{
    PRECISE float sum = state.f[COEFFICIENTS - 1];
    UNROLL
    for (int node = 0; node < COEFFICIENTS - 1; ++node)
    {
        int level = node >= 7 ? 3 : (node >= 3 ? 2 : (node >= 1 ? 1 : 0));
        int half_cell = leaf >> (WAVELET_RANK - level);
        bool inside = half_cell / 2 == node + 1 - (1 << level);
        float sign = half_cell % 2 == 0 ? -1.0f : 1.0f;
        sum = sum + (inside ? sign * level_scale(level) * state.f[node] : 0.0f);
    }
    return sum;
}

/// Absorbance in front of a depth in [0, 1]: linear interpolation between the means of the cells.
FN float absorbance_at(IN(PixelState) state, float depth)
{
    PRECISE float x = cell_depth(depth) * 16.0f;
    int leaf = min(int(x), COEFFICIENTS - 1);
    PRECISE float t = x - float(leaf);
    float before = leaf > 0 ? mean_absorbance(state, leaf - 1) : 0.0f;
    PRECISE float absorbance = before + t * (mean_absorbance(state, leaf) - before);
    return absorbance;
}

FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    return transmittance_of(max(absorbance_at(state, fragment.depth), 0.0f));
}

/// No absorbance lies beyond the start of the last cell, so the mean of A over it is the exact total.
FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    return transparent(transmittance_of(max(mean_absorbance(state, COEFFICIENTS - 1), 0.0f)));
}
