// moments.glsl -- what a pixel stores, in any basis of MOMENT_FLOATS real moments beside the zeroth.

/// The zeroth moment b0 (total absorbance, >= 0) and the others, not normalised. Power moments: b[i] = b_{i+1}.
/// Trigonometric: Re b_1, Im b_1, Re b_2, ...
struct Moments { float b0; float b[MOMENT_FLOATS]; };

/// Moments with what bias adds to them, kept apart: b[i] + bias_delta[i], not normalised. Added up they would lose most digits
/// of a small bias_delta, which is all that keeps the matrix of a few fragments regular.
struct BiasedMoments { float b0; float b[MOMENT_FLOATS]; float bias_delta[MOMENT_FLOATS]; };
