// stored_moments.glsl -- reads what the first pass stored, and reconstructs the transmittance to a fragment.
#include "shared/storage.glsl"
#include "passes/moment_texels.glsl"
#include "shared/reconstruction.glsl"
#ifdef TEXTBOOK_SOLVER
#include "shared/textbook.glsl"
#endif

layout(binding = 0) uniform sampler2D total_absorbance_texture;
layout(binding = 1) uniform sampler2D moments_1_to_4_texture;
#if MOMENT_FLOATS > 4
layout(binding = 2) uniform sampler2D moments_5_to_8_texture;
#endif

Moments stored_moments(ivec2 pixel)
{
    float b0 = texelFetch(total_absorbance_texture, pixel, 0).x;
    vec4 first = texelFetch(moments_1_to_4_texture, pixel, 0);
#if MOMENT_FLOATS > 4
    vec4 second = texelFetch(moments_5_to_8_texture, pixel, 0);
#else
    vec4 second = vec4(0.0);
#endif
    return unpacked_moments(moments_of_texels(b0, first, second));
}

/// A(z_f, b, beta) / b_0 for the fragment at hand, before it is clamped; NaN where the textbook solver breaks.
float fragment_fraction(Moments moments)
{
#ifdef TEXTBOOK_SOLVER
    precise float fraction = textbook_fraction(moments, fragment_depth(), frame.parameters.z, frame.parameters.x,
                                               make_basis(frame.parameters.y));
#else
    Factor factor = factor_moments(biased_moments(moments, frame.parameters.z));
    Reconstruction at_depth = reconstruct(factor, make_basis(frame.parameters.y), fragment_depth());
    precise float fraction = fraction_in_front(at_depth, frame.parameters.x);
#endif
    return fraction;
}

/// T(z_f, b, beta) for the fragment at hand.
float fragment_transmittance()
{
    Moments moments = stored_moments(ivec2(gl_FragCoord.xy));
    if (is_empty(moments)) return 1.0;
    precise float absorbance = moments.b0 * number_in_unit_range(fragment_fraction(moments));
    precise float transmittance = transmittance_of(absorbance);
    return transmittance;
}
