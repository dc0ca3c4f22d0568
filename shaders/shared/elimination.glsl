// elimination.glsl -- what the factorisations of both bases share.
//
// Where fragments are few, nearly all of the matrix of moments cancels in its elimination, and what is left, hardly more
// than the bias, decides the result. So it runs on pairs of floats and without division (Bareiss): each step multiplies
// what is left by its pivot, which a scale keeps track of, and by a power of two that keeps the scale near 1.

/// A pivot below this is rounding noise (1 ulp of a normalised moment) and counts as this.
const float PIVOT_FLOOR = 6.0e-8f;

/// b[i] + bias_delta[i] times a power of two, without rounding.
FN FloatPair biased_moment(IN(BiasedMoments) biased, int i, float power_of_two)
{
    return exact_sum(biased.b[i] * power_of_two, biased.bias_delta[i] * power_of_two);
}

struct Pivot
{
    FloatPair value;         // as it stands in the matrix, that is times the scale, raised to the floor
    float inverse;           // of it
    float inverse_h;         // of the pivot normalised: what LDL^T would have
    float power_of_two;      // the step multiplies the rest by it and by the pivot
    int floored;             // 1 if it was raised
};

/// The pivot of one step. scale: what the matrix has been multiplied by so far, in [1, 2^ORDER).
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

/// The scale after the step.
FN float next_scale(float scale, IN(Pivot) pivot)
{
    PRECISE float next = scale * pivot.value.high * pivot.power_of_two;
    return next;
}

/// (entry pivot - a b) times the power of two: an entry after the step.
FN FloatPair eliminated(IN(FloatPair) entry, IN(Pivot) pivot, IN(FloatPair) a, IN(FloatPair) b)
{
    return scaled_pair(pair_difference(pair_product(entry, pivot.value), pair_product(a, b)), pivot.power_of_two);
}

/// (entry pivot - a b - c d) times the power of two: half of a complex entry after the step.
FN FloatPair eliminated_half(IN(FloatPair) entry, IN(Pivot) pivot, IN(FloatPair) a, IN(FloatPair) b, IN(FloatPair) c,
                             IN(FloatPair) d)
{
    FloatPair first = pair_difference(pair_product(entry, pivot.value), pair_product(a, b));
    return scaled_pair(pair_difference(first, pair_product(c, d)), pivot.power_of_two);
}
