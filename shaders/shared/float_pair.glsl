// float_pair.glsl -- numbers with twice the digits of a float, as unevaluated sums of two floats. Uses only + - * (Dekker 1971).

struct FloatPair { float high; float low; };   // the number is high + low; |low| is at most a few ulps of high

FN FloatPair make_pair(float high, float low)
{
    FloatPair pair;
    pair.high = high;
    pair.low = low;
    return pair;
}

/// One of two pairs. WebGL has no `? :` for structs.
FN FloatPair choose_pair(bool first, IN(FloatPair) a, IN(FloatPair) b)
{
    return make_pair(first ? a.high : b.high, first ? a.low : b.low);
}

/// a + b without rounding (Knuth's two-sum).
FN FloatPair exact_sum(float a, float b)
{
    PRECISE float high = a + b;
    PRECISE float b_part = high - a;
    PRECISE float low = (a - (high - b_part)) + (b - b_part);
    return make_pair(high, low);
}

/// a + b. Exact if |a| >= |b| or a = 0 (Dekker's fast two-sum); otherwise its low part is rounded.
FN FloatPair ordered_sum(float a, float b)
{
    PRECISE float high = a + b;
    PRECISE float low = b - (high - a);
    return make_pair(high, low);
}

/// x as the sum of two floats of 12 bits each, so that products of such floats are exact (Dekker).
FN FloatPair halves_of(float x)
{
    PRECISE float scaled = 4097.0f * x;
    PRECISE float high = scaled - (scaled - x);
    PRECISE float low = x - high;
    return make_pair(high, low);
}

/// a b without rounding, unless it overflows or underflows. FUSED_MULTIPLY_ADD is defined where fma rounds once.
FN FloatPair exact_product(float a, float b)
{
    PRECISE float high = a * b;
#ifdef FUSED_MULTIPLY_ADD
    PRECISE float low = fma(a, b, -high);
#else
    FloatPair x = halves_of(a);
    FloatPair y = halves_of(b);
    PRECISE float low = ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low;
#endif
    return make_pair(high, low);
}

/// a b, rounded to a pair.
FN FloatPair pair_product(IN(FloatPair) a, IN(FloatPair) b)
{
    FloatPair result = exact_product(a.high, b.high);
    PRECISE float low = result.low + (a.high * b.low + a.low * (b.high + b.low));
    result.low = low;
    return result;
}

/// a - b. Accurate even if most digits cancel.
FN FloatPair pair_difference(IN(FloatPair) a, IN(FloatPair) b)
{
    FloatPair high = exact_sum(a.high, -b.high);
    PRECISE float low = high.low + (a.low - b.low);
    return ordered_sum(high.high, low);
}

FN FloatPair negative_pair(IN(FloatPair) pair)
{
    return make_pair(-pair.high, -pair.low);
}

/// The pair times a power of two, without rounding.
FN FloatPair scaled_pair(IN(FloatPair) pair, float power_of_two)
{
    return make_pair(pair.high * power_of_two, pair.low * power_of_two);
}
