// elimination.glsl -- the parts of the elimination that moments on the line and on the circle share.
//
// If a pixel has few fragments, nearly all of the matrix of moments cancels during elimination. What is left is hardly more than
// the bias, and it decides the result. So elimination runs on pairs of floats and does not divide (Bareiss). A plain step with the
// pivot P replaces entry E_ij by E_ij - E_ik E_jk / P. Here the step computes (E_ij P - E_ik E_jk) 2^-e, which is P 2^-e times as
// much. `scale` is the product of these factors, and the power of two keeps each of them in [1, 2).

/// Smaller pivots are rounding noise (1 ulp of a normalised moment) and are raised to this value.
const float PIVOT_FLOOR = 6.0e-8f;

/// (b[i] + bias_delta[i]) times a power of two, without rounding.
FN FloatPair biased_moment(IN(BiasedMoments) biased, int i, float power_of_two)
{
    return exact_sum(biased.b[i] * power_of_two, biased.bias_delta[i] * power_of_two);
}

struct Pivot
{
    FloatPair value;         // the entry of the matrix, including the factor scale; at least the floor
    float inverse;           // 1 / value
    float inverse_h;         // 1 / (value / scale): the inverse of the pivot that LDL^T of the normalised matrix has
    float power_of_two;      // the step multiplies the remaining entries by this and by value
    int floored;             // 1 if the pivot was raised to the floor
};

/// The pivot of one step. scale: the factor of the matrix so far, in [1, 2^ORDER).
FN Pivot make_pivot(IN(FloatPair) diagonal, float scale)
{
    PRECISE float floor_value = PIVOT_FLOOR * scale;
    bool low = diagonal.high < floor_value;
    Pivot pivot;
    pivot.floored = low ? 1 : 0;
    pivot.value.high = low ? floor_value : diagonal.high;
    pivot.value.low = low ? 0.0f : diagonal.low;
    pivot.inverse = 1.0f / pivot.value.high;
    pivot.inverse_h = scale / pivot.value.high;
    pivot.power_of_two = inverse_power_of_two(pivot.value.high);
    return pivot;
}

/// The factor of the matrix after the step.
FN float next_scale(float scale, IN(Pivot) pivot)
{
    PRECISE float next = scale * pivot.value.high * pivot.power_of_two;
    return next;
}

/// (entry pivot - a b) times the power of two: the entry after the step. a, b: the entries of its row and its column in the column
/// of the pivot.
FN FloatPair eliminated(IN(FloatPair) entry, IN(Pivot) pivot, IN(FloatPair) a, IN(FloatPair) b)
{
    return scaled_pair(pair_difference(pair_product(entry, pivot.value), pair_product(a, b)), pivot.power_of_two);
}

/// (entry pivot - a b - c d) times the power of two: the real or the imaginary part of a complex entry after the step.
FN FloatPair eliminated_half(IN(FloatPair) entry, IN(Pivot) pivot, IN(FloatPair) a, IN(FloatPair) b, IN(FloatPair) c,
                             IN(FloatPair) d)
{
    FloatPair first = pair_difference(pair_product(entry, pivot.value), pair_product(a, b));
    return scaled_pair(pair_difference(first, pair_product(c, d)), pivot.power_of_two);
}
