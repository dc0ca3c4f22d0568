// stored_moments.glsl -- the transmittance to a fragment from the moments of its pixel or, with STORED_FACTOR, from their factor,
// which factor.frag computed once for all fragments of the pixel.
#ifdef STORED_FACTOR
#include "shared/storage.glsl"
#else
#include "passes/moment_textures.glsl"
#endif
#include "shared/reconstruction.glsl"
#include "passes/frame_basis.glsl"
#ifdef TEXTBOOK_SOLVER
#include "shared/textbook.glsl"
#endif
#ifdef STORED_FACTOR
#include "passes/stored_factor.glsl"
#endif

/// A(z_f, b, beta) / b_0 for the current fragment from the factor of its pixel, not clamped yet.
float fragment_fraction(Factor factor)
{
    Reconstruction at_depth = reconstruct(factor, frame_basis(), fragment_depth());
    precise float fraction = fraction_in_front(at_depth, frame.parameters.x);
    return fraction;
}

/// The same from the moments of its pixel. NaN if the textbook solver breaks down.
float fragment_fraction(Moments moments)
{
#ifdef TEXTBOOK_SOLVER
    precise float fraction = textbook_fraction(moments, fragment_depth(), frame.parameters.y, frame.parameters.x,
                                               frame_basis());
    return fraction;
#else
    return fragment_fraction(factor_moments(biased_moments(moments, frame.parameters.y)));
#endif
}

/// T(z_f, b, beta) for the current fragment.
float fragment_transmittance()
{
#ifdef STORED_FACTOR
    Factor pixel = stored_factor(ivec2(gl_FragCoord.xy));
    if (!(pixel.b0 >= MIN_ABSORBANCE)) return 1.0;
#else
    Moments pixel = stored_moments(ivec2(gl_FragCoord.xy));
    if (is_empty(pixel)) return 1.0;
#endif
    precise float absorbance = pixel.b0 * number_in_unit_range(fragment_fraction(pixel));
    precise float transmittance = transmittance_of(absorbance);
    return transmittance;
}
