// stochastic.glsl -- stochastic transparency (Enderton et al. 2010). A fragment covers each sample of its pixel with a probability
// equal to its opacity. Samples keep the nearest depth. The share of samples in which a depth is visible is an unbiased estimate of
// its transmittance.
#define MAX_STATE_FLOATS 68
#define STATE_SAMPLES
#define SETTINGS(S) S(int, samples) S(bool, renormalize)   // 1 to 64 samples; renormalize: the alpha correction
#include "pixel_state.glsl"

const float NO_DEPTH = 2.0f;   // of a sample that no fragment covers

/// f[0]: the total absorbance. f[1 + s]: the depth of sample s.
FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    PixelState state;
    for (int i = 0; i < MAX_STATE_FLOATS; ++i) state.f[i] = i == 0 ? 0.0f : NO_DEPTH;
    return state;
}

FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = empty_state(settings);
    state.f[0] = absorbance_of_opacity(fragment.opacity);
    for (int s = 0; s < settings.samples; ++s)
        state.f[1 + s] = unit_random(fragment.seed, s) < fragment.opacity ? fragment.depth : NO_DEPTH;
    return state;
}

/// The share of samples in which nothing lies strictly in front of the fragment.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float seeing = 0.0f;
    for (int s = 0; s < settings.samples; ++s) seeing = state.f[1 + s] >= fragment.depth ? seeing + 1.0f : seeing;
    return seeing / float(settings.samples);
}

/// Without alpha correction, the total transmittance is the share of samples that no fragment covers.
FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    float empty = 0.0f;
    for (int s = 0; s < settings.samples; ++s) empty = state.f[1 + s] == NO_DEPTH ? empty + 1.0f : empty;
    return transparent(settings.renormalize ? transmittance_of(state.f[0]) : empty / float(settings.samples));
}
