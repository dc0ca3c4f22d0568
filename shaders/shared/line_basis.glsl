// line_basis.glsl -- what power and Chebyshev moments are made of: as many floats as moments, half as many roots, and at
// most one parameter.

#define LINE_BASIS
#define ROOT_COUNT (MOMENT_COUNT / 2)
#define MOMENT_FLOATS MOMENT_COUNT
#define ORDER (ROOT_COUNT + 1)   // of the matrix of moments
#include "moments.glsl"
#include "float_pair.glsl"
#include "elimination.glsl"
#include "real_roots.glsl"

/// What depends on parameters but not on depth: the tolerance of nested orders (nested_orders.glsl), and else nothing.
/// Trigonometric moments have a wrapping zone here.
struct Basis { float tolerance; };

FN Basis make_basis(float tolerance)
{
    Basis basis;
    basis.tolerance = tolerance;
    return basis;
}

/// The same as numbers, for a uniform block.
#define BASIS_FLOATS 1
struct StoredBasis { float x[BASIS_FLOATS]; };

FN StoredBasis packed_basis(IN(Basis) basis)
{
    StoredBasis stored;
    stored.x[0] = basis.tolerance;
    return stored;
}

FN Basis unpacked_basis(IN(StoredBasis) stored)
{
    return make_basis(stored.x[0]);
}
