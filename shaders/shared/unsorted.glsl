// unsorted.glsl -- alpha blending in the order of submission (Porter and Duff 1984).
#define MAX_STATE_FLOATS 4
#define STATE_OVER
#define HOLDS_COLORS
#define WITHOUT_DEPTHS
#include "pixel_state.glsl"

FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    return zero_state();
}

/// Colour multiplied by opacity, and opacity.
FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    state.f[0] = fragment.opacity * fragment.red;
    state.f[1] = fragment.opacity * fragment.green;
    state.f[2] = fragment.opacity * fragment.blue;
    state.f[3] = fragment.opacity;
    return state;
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    Composited result;
    result.red = state.f[0];
    result.green = state.f[1];
    result.blue = state.f[2];
    result.transmittance = 1.0f - state.f[3];
    return result;
}
