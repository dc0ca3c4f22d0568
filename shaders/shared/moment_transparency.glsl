// moment_transparency.glsl -- Moment Transparency (Sharpe 2018). It stores four power moments of the depth between the near and the
// far plane of the camera. Moments may have a low resolution and may be read in fewer bits. A second set of moments may weigh each
// fragment by how visible it is according to the first set. Equations and sections are those of Sharpe 2018.
#define MAX_STATE_FLOATS 16
#define STATE_SUMS
#define SETTINGS(S) S(int, read_format) S(int, moment_passes) S(int, depth_range) S(float, beta) S(float, alpha)
const int READ_FLOATS = 0;          // read_format: floats, as stored
const int READ_THETA16 = 1;         // 16 bits per moment, after the transform Theta_4
const int READ_NLQM64 = 2;          // non-linearly quantised moments of 64 bits
const int READ_NLQM32 = 3;          // the same of 32 bits
const int ONE_PASS = 0;             // moment_passes: one set of moments
const int SECOND_OF_OPACITY = 1;    // a second set, of opacities times the transmittance that the first set gives
const int SECOND_OF_VISIBILITY = 2; // a second set, of these products themselves, without the logarithm
const int DEPTHS_CORRECTED = 0;     // depth_range: [-1, 1], for which the bias vector was made
const int DEPTHS_PUBLISHED = 1;     // [0, 1]
#define SECOND_STATE         // second_fragment_state
#define EXACT_ABSORBANCE_SLOT 5     // the total absorbance of the pixel itself, which the second pass sums
#include "pixel_state.glsl"
#define MOMENT_COUNT 4
#define MOMENT_BITS 32
#include "power_moments.glsl"
#include "reconstruction.glsl"
#define THETA_TRANSFORM
#include "unorm16_storage.glsl"
#include "nonlinear_quantisation.glsl"

const int SECOND = 8;   // f[0 ... 4]: b_0 ... b_4; f[8 ... 12]: the same of the second set

/// The depth that moments are taken of: Equation 6, and then mapped to [-1, 1], unless the published range is chosen.
FN float moment_depth(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    return settings.depth_range == DEPTHS_PUBLISHED ? fragment.plane_depth : 2.0f * fragment.plane_depth - 1.0f;
}

FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    return zero_state();
}

FN PixelState with_moments(IN(PixelState) state, int first, IN(Moments) moments)
{
    PixelState result = state;
    result.f[first] = moments.b0;
    UNROLL
    for (int i = 0; i < 4; ++i) result.f[first + 1 + i] = moments.b[i];
    return result;
}

FN Moments moments_in(IN(PixelState) state, int first)
{
    Moments moments;
    moments.b0 = state.f[first];
    UNROLL
    for (int i = 0; i < 4; ++i) moments.b[i] = state.f[first + 1 + i];
    return moments;
}

/// What blending adds in the first pass (Equations 2 to 4).
FN PixelState fragment_state(IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    Moments moments = fragment_moments(moment_depth(fragment, settings), absorbance_of_opacity(fragment.opacity),
                                       make_basis(0.0f));
    return with_moments(zero_state(), 0, moments);
}

/// Biases moments towards the vector for the rounding of the read format (Peters and Klein 2015; Peters et al. 2017).
FN BiasedMoments biased_for(IN(Moments) moments, IN(PixelStateSettings) settings)
{
    float target = settings.read_format == READ_THETA16 ? 0.628f : 0.375f;
    BiasedMoments biased;
    biased.b0 = moments.b0;
    UNROLL
    for (int i = 0; i < 4; ++i)
    {
        biased.b[i] = moments.b[i];
        PRECISE float bias_delta = settings.alpha * (moments.b0 * (i % 2 == 0 ? 0.0f : target) - moments.b[i]);
        biased.bias_delta[i] = bias_delta;
    }
    return biased;
}

/// One set of moments, rounded as the read format rounds it.
FN Moments in_read_format(IN(Moments) moments, IN(PixelStateSettings) settings)
{
    if (settings.read_format == READ_FLOATS || is_empty(moments)) return moments;
    Moments result;
    if (settings.read_format == READ_THETA16)
    {
        Moments nothing;
        nothing.b0 = 0.0f;
        UNROLL
        for (int i = 0; i < 4; ++i) nothing.b[i] = 0.0f;
        result = with_fragment(nothing, moments);   // the sum of all fragments is stored like a single fragment
        return result;
    }
    BiasedMoments biased = biased_for(moments, settings);
    float b[4];
    UNROLL
    for (int i = 0; i < 4; ++i)
    {
        PRECISE float sum = biased.b[i] + biased.bias_delta[i];
        b[i] = sum / moments.b0;
    }
    TwoDepths exact = two_depths(b[0], b[1], b[2], b[3]);
    TwoDepths quantised = exact;
    if (settings.read_format == READ_NLQM64) quantised = rounded_to_64_bits(exact);
    else quantised = rounded_to_32_bits(exact);
    result.b0 = moments.b0;   // b_0 stays a float
    result.b[0] = quantised.near;
    result.b[1] = quantised.far;
    result.b[2] = quantised.weight;
    result.b[3] = quantised.offset;
    return result;
}

/// The state in the read format, before it is filtered. The second pass reads it.
FN PixelState converted(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    PixelState first = with_moments(state, 0, in_read_format(moments_in(state, 0), settings));
    return with_moments(first, SECOND, in_read_format(moments_in(state, SECOND), settings));
}

/// The state in a form that may be mixed with that of neighbouring pixels: moments that are not normalised. Non-linearly quantised
/// moments must not be mixed.
FN PixelState filterable(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    if (settings.read_format != READ_THETA16) return state;
    PixelState first = with_moments(state, 0, unpacked_moments(moments_in(state, 0)));
    return with_moments(first, SECOND, unpacked_moments(moments_in(state, SECOND)));
}

/// The share of the mass of one set that lies in front of a depth, in [0, 1].
FN float fraction_of(IN(Moments) moments, float depth, IN(PixelStateSettings) settings)
{
    if (settings.read_format >= READ_NLQM64)
    {
        TwoDepths quantised;
        quantised.near = moments.b[0];
        quantised.far = moments.b[1];
        quantised.weight = moments.b[2];
        quantised.offset = moments.b[3];
        return number_in_unit_range(fraction_of_two_depths(quantised, depth, settings.beta));
    }
    Factor factor = factor_moments(biased_for(moments, settings));
    return number_in_unit_range(
        fraction_in_front(reconstruct(factor, make_basis(0.0f), depth), settings.beta));
}

/// Transmittance to the fragment from the first set (Equation 5). state: result of filterable.
FN float first_transmittance(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    Moments moments = moments_in(state, 0);
    if (is_empty(moments)) return 1.0f;
    return transmittance_of(moments.b0 * fraction_of(moments, moment_depth(fragment, settings), settings));
}

/// What blending adds in the second moment pass. state: result of filterable for the first pass. Section 4.4 can be read in two
/// ways, and both are here.
FN PixelState second_fragment_state(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float visibility = fragment.opacity * first_transmittance(state, fragment, settings);
    float mass = settings.moment_passes == SECOND_OF_VISIBILITY ? visibility : absorbance_of_opacity(visibility);
    Moments moments = fragment_moments(moment_depth(fragment, settings), mass, make_basis(0.0f));
    return with_moments(zero_state(), SECOND, moments);
}

/// Transmittance to the fragment. state: result of filterable. With two sets, the total of the first is distributed over depth like
/// the second set, either as absorbance or as opacity.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    Moments second = moments_in(state, SECOND);
    if (settings.moment_passes == ONE_PASS || is_empty(second)) return first_transmittance(state, fragment, settings);
    float fraction = fraction_of(second, moment_depth(fragment, settings), settings);
    if (settings.moment_passes == SECOND_OF_OPACITY) return transmittance_of(state.f[0] * fraction);
    return 1.0f - (1.0f - transmittance_of(state.f[0])) * fraction;
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    return transparent(transmittance_of(state.f[EXACT_ABSORBANCE_SLOT]));
}
