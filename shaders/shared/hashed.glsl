// hashed.glsl -- hashed alpha testing (Wyman and McGuire 2017). A fragment is drawn as opaque if its opacity reaches a threshold,
// and not at all otherwise. The threshold is a hash of the place on the object. No settings.
#define MAX_STATE_FLOATS 4
#define STATE_NEAREST
#define HOLDS_COLORS
#include "pixel_state.glsl"

const float NO_DEPTH = 2.0f;   // the depth of a pixel where nothing is drawn

/// The state holds the colour and the depth of the drawn fragment.
FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    state.f[3] = NO_DEPTH;
    return state;
}

FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = empty_state(settings);
    if (fragment.opacity < fragment.threshold) return state;
    state.f[0] = fragment.red;
    state.f[1] = fragment.green;
    state.f[2] = fragment.blue;
    state.f[3] = fragment.depth;
    return state;
}

/// 1 for fragments that are drawn and do not lie behind the stored depth, otherwise 0.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    bool seen = fragment.opacity >= fragment.threshold && fragment.depth <= state.f[3];
    return seen ? 1.0f : 0.0f;
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    Composited result = transparent(state.f[3] == NO_DEPTH ? 1.0f : 0.0f);
    result.red = state.f[0];
    result.green = state.f[1];
    result.blue = state.f[2];
    return result;
}
