// caster_moments.glsl -- transparent casters as moments. The sums are b_0 and the other moments. Include it after the basis.
#include "shared/float_storage.glsl"
#include "shared/reconstruction.glsl"
#include "shared/ends.glsl"
#include "shared/fragment_estimate.glsl"

struct CasterSums { float f[16]; };

/// What one fragment adds to the sums. depth in [-1, 1]. settings: as for caster_transmittance.
FN CasterSums caster_sums(float depth, float opacity, IN(vec4) settings)
{
    Moments moments = fragment_moments(depth, absorbance_of_opacity(opacity), make_basis(settings.y));
    CasterSums sums;
    for (int i = 0; i < 16; ++i) sums.f[i] = 0.0;
    sums.f[0] = moments.b0;
    for (int i = 0; i < MOMENT_FLOATS; ++i) sums.f[1 + i] = moments.b[i];
    return sums;
}

/// The transmittance to a receiver at a depth in [-1, 1]. own: the absorbance of the receiver, if it casts shadows, too; it does not
/// shadow itself. settings: beta; theta or epsilon; alpha.
FN float caster_transmittance(IN(CasterSums) sums, float depth, float own, IN(vec4) settings)
{
    Moments moments;
    moments.b0 = sums.f[0];
    for (int i = 0; i < MOMENT_FLOATS; ++i) moments.b[i] = sums.f[1 + i];
    if (is_empty(moments)) return 1.0;
    Factor factor = factor_moments(biased_moments(moments, settings.z));
    QueryMasses masses = query_masses(reconstruct(factor, make_basis(settings.y), depth));
    return estimate_at(masses, moments.b0, own, AT_NO_END, ESTIMATE_OWN_BETA, settings.x).transmittance;
}
