// line_basis.glsl -- what power and Chebyshev moments are made of: as many floats as moments, half as many roots, and no
// parameters.

#define ROOT_COUNT (MOMENT_COUNT / 2)
#define MOMENT_FLOATS MOMENT_COUNT
#define ORDER (ROOT_COUNT + 1)   // of the matrix of moments
#include "moments.glsl"
#include "float_pair.glsl"
#include "elimination.glsl"
#include "real_roots.glsl"

/// What depends on parameters but not on depth: nothing. Trigonometric moments have a wrapping zone here.
struct Basis { float wrapping_zone_angle; };

FN Basis make_basis(float wrapping_zone_angle)
{
    Basis basis;
    basis.wrapping_zone_angle = wrapping_zone_angle;
    return basis;
}
