// weighted.glsl -- weighted blended transparency (McGuire and Bavoil 2013). Each colour has a weight that guesses how much of the
// fragment is seen, from its own depth and opacity alone.
#define MAX_STATE_FLOATS 8
#define STATE_SUMS
#define HOLDS_COLORS
#define SETTINGS(S) S(int, weight)   // weight: one of the following
const int WEIGHT_OF_WINDOW_DEPTH = 0;
const int WEIGHT_OF_VIEW_DEPTH = 1;          // McGuire and Bavoil 2013
const int WEIGHT_OF_G3D = 2;                 // McGuire and Mara 2017
#include "pixel_state.glsl"

FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    return zero_state();
}

/// The weight of a fragment. For WEIGHT_OF_WINDOW_DEPTH, with window depth z and opacity alpha, it is
/// clamp((10 (1 - 0.99 z) alpha)^3, 0.01, 30).
FN float blending_weight(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float near_and_opaque = 10.0f * (1.0f - 0.99f * fragment.window_depth) * fragment.opacity;
    float phenomenological = clamp(near_and_opaque * near_and_opaque * near_and_opaque, 0.01f, 30.0f);
    float distance = fragment.view_depth / 200.0f;
    float falloff = clamp(0.03f / (1.0e-5f + distance * distance * distance * distance), 0.01f, 3.0e3f);
    float brightest = max(max(fragment.red, fragment.green), fragment.blue) * fragment.opacity;
    float bright = min(1.0f, 40.0f * max(brightest, fragment.opacity) + 0.01f);
    float g3d = (8.0f * fragment.opacity + 0.01f) * (1.0f - 0.95f * fragment.window_depth);
    float g3d_weight = clamp(1.0e3f * g3d * g3d * g3d, 0.01f, 300.0f);
    if (settings.weight == WEIGHT_OF_VIEW_DEPTH) return falloff * bright * bright;
    return settings.weight == WEIGHT_OF_G3D ? g3d_weight : phenomenological;
}

/// The state holds weighted colour, weighted opacity and absorbance.
FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    float weight = blending_weight(fragment, settings) * fragment.opacity;
    state.f[0] = weight * fragment.red;
    state.f[1] = weight * fragment.green;
    state.f[2] = weight * fragment.blue;
    state.f[3] = weight;
    state.f[4] = absorbance_of_opacity(fragment.opacity);
    return state;
}

/// How much of the fragment is seen, relative to its opacity: its share of the coverage. It may exceed 1.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float coverage = 1.0f - transmittance_of(state.f[4]);
    return blending_weight(fragment, settings) * coverage / max(state.f[3], 1.0e-30f);
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    Composited result;
    result.transmittance = transmittance_of(state.f[4]);
    float scale = (1.0f - result.transmittance) / max(state.f[3], 1.0e-30f);
    result.red = state.f[0] * scale;
    result.green = state.f[1] * scale;
    result.blue = state.f[2] * scale;
    return result;
}
