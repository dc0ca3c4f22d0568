// frame_basis.glsl -- the Basis, which depends on parameters but not on depth. The CPU computes it once per frame. Include this
// after the technique.

Basis frame_basis()
{
    StoredBasis stored;
    UNROLL
    for (int i = 0; i < BASIS_FLOATS; ++i) stored.x[i] = frame.basis[i / 4][i % 4];
    return unpacked_basis(stored);
}
