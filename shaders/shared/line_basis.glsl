// line_basis.glsl -- constants and includes that power and Chebyshev moments share. They store as many floats as moments, have half
// as many roots, and have at most one parameter.

#define LINE_BASIS
#define ROOT_COUNT (MOMENT_COUNT / 2)
#define MOMENT_FLOATS MOMENT_COUNT
#define ORDER (ROOT_COUNT + 1)   // number of rows of the matrix of moments
#include "moments.glsl"
#include "float_pair.glsl"
#include "elimination.glsl"
#include "real_roots.glsl"

/// Numbers that depend on parameters but not on depth. Here this is the tolerance of nested orders (nested_orders.glsl); other
/// bases on the line do not read it. Trigonometric moments have their wrapping zone here.
struct Basis { float tolerance; };

FN Basis make_basis(float tolerance)
{
    Basis basis;
    basis.tolerance = tolerance;
    return basis;
}

/// A Basis as an array of numbers, for a uniform block.
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
