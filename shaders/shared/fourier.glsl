// fourier.glsl -- Fourier opacity mapping (Jansen and Bavoil 2010). A pixel stores a Fourier series of the absorption as a function
// of depth.
#define MAX_STATE_FLOATS 16
#define STATE_SUMS
#define SETTINGS(S) S(int, coefficients) S(bool, lanczos)   // lanczos: damp the terms by Lanczos' sigma factors?
#include "pixel_state.glsl"

const int MAX_FREQUENCY = 7;

/// K of a series with 2K + 1 real coefficients: 7 of them (the choice 0) or 15.
FN int frequencies(IN(PixelStateSettings) settings)
{
    return settings.coefficients == 0 ? 3 : MAX_FREQUENCY;
}

/// The state holds a_0, then a_1, b_1, a_2, b_2, and so on.
FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    return zero_state();
}

/// cos(k angle) and sin(k angle) for k = 0, 1, ...
struct Waves { float cosine[MAX_FREQUENCY + 1]; float sine[MAX_FREQUENCY + 1]; };

/// The waves of all k, from the sine and cosine for k = 1.
FN Waves waves_of(IN(SinCos) first)
{
    Waves waves;
    waves.cosine[0] = 1.0f;
    waves.sine[0] = 0.0f;
    UNROLL
    for (int k = 1; k <= MAX_FREQUENCY; ++k)
    {
        PRECISE float cosine = waves.cosine[k - 1] * first.cosine - waves.sine[k - 1] * first.sine;
        PRECISE float sine = waves.cosine[k - 1] * first.sine + waves.sine[k - 1] * first.cosine;
        waves.cosine[k] = cosine;
        waves.sine[k] = sine;
    }
    return waves;
}

/// The waves of the angle 2 pi depth.
FN Waves depth_waves(float depth)
{
    SinCos half_angle = portable_sincos(PI * depth);
    PRECISE float cosine = half_angle.cosine * half_angle.cosine - half_angle.sine * half_angle.sine;
    PRECISE float sine = 2.0f * (half_angle.sine * half_angle.cosine);
    SinCos angle;
    angle.cosine = cosine;
    angle.sine = sine;
    return waves_of(angle);
}

/// What one fragment adds. With its absorbance A_l and its depth d_l: 2 A_l cos(2 pi k d_l) to a_k and 2 A_l sin(2 pi k d_l) to
/// b_k.
FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    float absorbance = absorbance_of_opacity(fragment.opacity);
    Waves waves = depth_waves(fragment.depth);
    state.f[0] = 2.0f * absorbance;
    UNROLL
    for (int k = 1; k <= MAX_FREQUENCY; ++k)
    {
        bool there = k <= frequencies(settings);
        state.f[2 * k - 1] = there ? 2.0f * absorbance * waves.cosine[k] : 0.0f;
        state.f[2 * k] = there ? 2.0f * absorbance * waves.sine[k] : 0.0f;
    }
    return state;
}

/// Absorbance in front of a depth d in [0, 1]. The absorption is a_0 / 2 + sum of (a_k cos(2 pi k d) + b_k sin(2 pi k d)). Its
/// integral from 0 to d is A(d) = a_0 d / 2 + sum of (a_k sin(2 pi k d) + b_k (1 - cos(2 pi k d))) / (2 pi k). The series rings:
/// A(d) may fall, and it may be negative.
FN float absorbance_at(IN(PixelState) state, float depth, IN(PixelStateSettings) settings)
{
    Waves waves = depth_waves(depth);
    float lanczos_angle = PI / (float(frequencies(settings)) + 1.0f);
    Waves lanczos = waves_of(portable_sincos(lanczos_angle));
    PRECISE float absorbance = 0.5f * state.f[0] * depth;
    UNROLL
    for (int k = 1; k <= MAX_FREQUENCY; ++k)
    {
        float sigma = settings.lanczos ? lanczos.sine[k] / (lanczos_angle * float(k)) : 1.0f;
        PRECISE float wave = (state.f[2 * k - 1] * waves.sine[k] + state.f[2 * k] * (1.0f - waves.cosine[k]))
            / (2.0f * PI * float(k));
        absorbance = absorbance + (k <= frequencies(settings) ? sigma * wave : 0.0f);
    }
    return absorbance;
}

FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    return transmittance_of(max(absorbance_at(state, fragment.depth, settings), 0.0f));
}

/// The total absorbance A(1) = a_0 / 2 is exact.
FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    return transparent(transmittance_of(0.5f * state.f[0]));
}
