// moments.glsl -- what a pixel stores in every basis: b_0 and MOMENT_FLOATS other real numbers.

/// The zeroth moment b0 (total absorbance, >= 0) and the other moments, not normalised. On the line b[i] = b_{i+1}. On the circle b
/// holds Re b_1, Im b_1, Re b_2, ...
struct Moments { float b0; float b[MOMENT_FLOATS]; };

/// Moments and, kept apart, what bias adds to them. The biased moments are b[i] + bias_delta[i], not normalised. If both were added
/// in floats, a small bias_delta would lose most of its digits. With few fragments it is all that keeps the matrix from being
/// singular.
struct BiasedMoments { float b0; float b[MOMENT_FLOATS]; float bias_delta[MOMENT_FLOATS]; };
