// fourier.glsl -- Fourier opacity mapping (Jansen and Bavoil 2010): the absorption over depth as a Fourier series. Settings: size
// is the greatest frequency K, 3 or 7; option 1 damps the series by Lanczos' sigma factors.
#define MAX_STATE_FLOATS 16
#define STATE_SUMS
#include "pixel_state.glsl"

const int MAX_FREQUENCY = 7;

/// a_0, then a_k and b_k in turn.
FN PixelState empty_state(IN(MethodSettings) settings)
{
    return zero_state();
}

/// 2 A_l cos(2 pi k d_l) and 2 A_l sin(2 pi k d_l).
FN PixelState fragment_state(IN(MethodFragment) fragment, IN(MethodSettings) settings)
{
    PixelState state = zero_state();
    float absorbance = absorbance_of_opacity(fragment.opacity);
    SinCos half_angle = portable_sincos(PI * fragment.depth);
    PRECISE float c = half_angle.cosine * half_angle.cosine - half_angle.sine * half_angle.sine;
    PRECISE float s = 2.0f * (half_angle.sine * half_angle.cosine);
    float cosine = 1.0f;
    float sine = 0.0f;
    state.f[0] = 2.0f * absorbance;
    UNROLL
    for (int k = 1; k <= MAX_FREQUENCY; ++k)
    {
        PRECISE float next_cosine = cosine * c - sine * s;
        PRECISE float next_sine = cosine * s + sine * c;
        cosine = next_cosine;
        sine = next_sine;
        bool there = k <= settings.size;
        state.f[2 * k - 1] = there ? 2.0f * absorbance * cosine : 0.0f;
        state.f[2 * k] = there ? 2.0f * absorbance * sine : 0.0f;
    }
    return state;
}

/// A(d) = a_0 d / 2 + sum of (a_k sin(2 pi k d) + b_k (1 - cos(2 pi k d))) / (2 pi k). It rings: neither monotone nor positive.
FN float absorbance_at(IN(PixelState) state, float depth, IN(MethodSettings) settings)
{
    SinCos half_angle = portable_sincos(PI * depth);
    PRECISE float c = half_angle.cosine * half_angle.cosine - half_angle.sine * half_angle.sine;
    PRECISE float s = 2.0f * (half_angle.sine * half_angle.cosine);
    SinCos lanczos = portable_sincos(PI / (float(settings.size) + 1.0f));
    float cosine = 1.0f;
    float sine = 0.0f;
    float lanczos_cosine = 1.0f;
    float lanczos_sine = 0.0f;
    PRECISE float absorbance = 0.5f * state.f[0] * depth;
    UNROLL
    for (int k = 1; k <= MAX_FREQUENCY; ++k)
    {
        PRECISE float next_cosine = cosine * c - sine * s;
        PRECISE float next_sine = cosine * s + sine * c;
        cosine = next_cosine;
        sine = next_sine;
        PRECISE float next_lanczos_cosine = lanczos_cosine * lanczos.cosine - lanczos_sine * lanczos.sine;
        PRECISE float next_lanczos_sine = lanczos_cosine * lanczos.sine + lanczos_sine * lanczos.cosine;
        lanczos_cosine = next_lanczos_cosine;
        lanczos_sine = next_lanczos_sine;
        float x = PI * float(k) / (float(settings.size) + 1.0f);
        float sigma = settings.option == 1 ? lanczos_sine / x : 1.0f;
        PRECISE float wave = (state.f[2 * k - 1] * sine + state.f[2 * k] * (1.0f - cosine)) / (2.0f * PI * float(k));
        absorbance = absorbance + (k <= settings.size ? sigma * wave : 0.0f);
    }
    return absorbance;
}

FN float transmittance_at(IN(PixelState) state, IN(MethodFragment) fragment, IN(MethodSettings) settings)
{
    return transmittance_of(max(absorbance_at(state, fragment.depth, settings), 0.0f));
}

/// A(1) = a_0 / 2 is exact.
FN Composited composited(IN(PixelState) state, IN(MethodSettings) settings)
{
    return transparent(transmittance_of(0.5f * state.f[0]));
}
