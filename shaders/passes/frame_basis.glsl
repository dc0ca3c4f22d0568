// frame_basis.glsl -- what depends on parameters but not on depth, computed once per frame by the CPU. Follows the technique.

Basis frame_basis()
{
    StoredBasis stored;
    UNROLL
    for (int i = 0; i < BASIS_FLOATS; ++i) stored.x[i] = frame.basis[i / 4][i % 4];
    return unpacked_basis(stored);
}
