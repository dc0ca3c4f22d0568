// stored_moments.glsl -- what is known of the transmittance to a fragment from the moments of its pixel or, with STORED_FACTOR, from
// their factor, which factor.frag computed once for all fragments of the pixel. ESTIMATE is a number of fragment_estimate.glsl.
#ifdef STORED_FACTOR
#include "shared/storage.glsl"
#else
#include "passes/moment_textures.glsl"
#endif
#include "shared/reconstruction.glsl"
#include "passes/pixel_ends.glsl"
#include "shared/fragment_estimate.glsl"
#include "passes/frame_basis.glsl"
#include "passes/factor_texels.glsl"
#ifdef TEXTBOOK_SOLVER
#include "shared/textbook.glsl"
#endif
#ifdef STORED_FACTOR
#include "passes/stored_factor.glsl"
#endif
#ifndef ESTIMATE
#define ESTIMATE ESTIMATE_BETA
#endif

/// The masses in front of the current fragment and at it, from the factor of its pixel.
QueryMasses fragment_masses(PixelFactor pixel)
{
    float depth = moment_depth(fragment_depth(), pixel.ends);
#ifdef WITH_INNER
    return sharp_masses(pixel.whole, pixel.inner, frame_basis(), depth);
#else
    return query_masses(reconstruct(pixel.whole, frame_basis(), depth));
#endif
}

/// The same from the moments of its pixel. The textbook solver knows only A(z_f, b, beta) / b_0, and returns it as the mass in
/// front. This is NaN if it breaks down.
QueryMasses fragment_masses(Moments moments, Ends ends)
{
#ifdef TEXTBOOK_SOLVER
    PRECISE float fraction =
        textbook_fraction(moments, fragment_depth(), frame.parameters.y, frame.parameters.x, frame_basis());
    return make_masses(fraction, 0.0);
#else
    return fragment_masses(factored(moments, ends, frame.parameters.y));
#endif
}

/// What the pixel knows of the current fragment.
FragmentEstimate fragment_estimate()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef STORED_FACTOR
    PixelFactor stored = stored_factor(pixel);
    Ends ends = stored.ends;
    float b0 = stored.whole.b0;
#else
    Moments stored = stored_moments(pixel);
    Ends ends = stored_ends(pixel);
    float b0 = stored.b0;
#endif
    if (!(b0 >= MIN_ABSORBANCE)) return estimate_at(make_masses(0.0, 0.0), 0.0, 0.0, AT_NO_END, ESTIMATE_BETA, 0.0);
    int end = end_at(fragment_depth(), ends);
#ifdef STORED_FACTOR
    QueryMasses between = fragment_masses(stored);
#else
    QueryMasses between = fragment_masses(stored, ends);
#endif
    QueryMasses masses = masses_at_end(between, end, IN_OWN_INTERVAL);
    return estimate_at(masses, b0, fragment_absorbance(), end, ESTIMATE, frame.parameters.x);
}

/// T for the current fragment.
float fragment_transmittance()
{
    PRECISE float transmittance = fragment_estimate().transmittance;
    return transmittance;
}
