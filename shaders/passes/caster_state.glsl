// caster_state.glsl -- transparent casters as the sums of a technique without moments, which is Fourier opacity mapping. Include it
// after the math file.

struct CasterSums { float f[16]; };

FN PixelStateSettings caster_settings()
{
    return PixelStateSettings(PIXEL_STATE_SETTINGS);
}

/// A caster or a receiver as a fragment. Only its depth, in [-1, 1], and its opacity are known; other members have fixed values.
FN PixelStateFragment caster_fragment(float depth, float opacity)
{
    PixelStateFragment fragment;
    fragment.depth = 0.5 * (depth + 1.0);
    fragment.view_depth = 1.0;
    fragment.window_depth = fragment.depth;
    fragment.plane_depth = fragment.depth;
    fragment.opacity = opacity;
    fragment.red = 0.0;
    fragment.green = 0.0;
    fragment.blue = 0.0;
    fragment.seed = 0u;
    fragment.threshold = 0.5;
    return fragment;
}

FN CasterSums caster_sums(float depth, float opacity, IN(vec4) settings)
{
    PixelState state = fragment_state(caster_fragment(depth, opacity), caster_settings());
    CasterSums sums;
    for (int i = 0; i < 16; ++i) sums.f[i] = state.f[i];
    return sums;
}

/// own is not used: a series does not tell how much of its mass lies at a depth.
FN float caster_transmittance(IN(CasterSums) sums, float depth, float own, IN(vec4) settings)
{
    PixelState state;
    for (int i = 0; i < 16; ++i) state.f[i] = sums.f[i];
    return transmittance_at(state, caster_fragment(depth, 0.0), caster_settings());
}
