// fragment_estimate.glsl -- what is known of the transmittance to a fragment. Three things bound the absorbance A in front of it:
// the moments of its pixel, its own absorbance, and the ends of its ray (docs/less_error.md). Include it after reconstruction.glsl,
// fragment.glsl and ends.glsl.

/// The mass in front of a query depth, and the mass at it, as shares of b_0. No distribution with the same moments has less mass in
/// front or more mass at the depth.
struct QueryMasses { float in_front; float at_query; };

FN QueryMasses make_masses(float in_front, float at_query)
{
    QueryMasses masses;
    masses.in_front = in_front;
    masses.at_query = at_query;
    return masses;
}

FN QueryMasses query_masses(IN(Reconstruction) reconstruction)
{
    return make_masses(reconstruction.in_front, reconstruction.query_weight);
}

#if defined(LINE_BASIS) && !defined(NESTED_ORDERS)
#define SHARP_BOUNDS   // sharp_masses
#include "line_interval.glsl"
#endif

/// How T is chosen.
const int ESTIMATE_BETA = 0;      // as published: A is in_front plus beta times at_query
const int ESTIMATE_OWN_BETA = 1;  // the same, but the mass at the query without the fragment itself
const int ESTIMATE_EXPECTED = 2;  // the mean of T if all A between the bounds are equally likely

struct FragmentEstimate
{
    float lower;           // A lies in [lower, upper], within [0, b_0 - own]
    float upper;
    float transmittance;   // T
    float spread;          // how far T may be moved when all weights are made to fit their sum; 0: T is certain
};

/// The mean of exp(-x) over x in [0, gap]: (1 - exp(-gap)) / gap. gap >= 0; through: exp(-gap). Up to gap = 1/16 the series is as good
/// as a float, and from there on the quotient is right to 1e-6.
FN float mean_through(float gap, float through)
{
    PRECISE float series = 1.0f - gap * (0.5f - gap * (0.166666667f - gap * 0.0416666667f));
    PRECISE float mean = gap < 0.0625f ? series : (1.0f - through) / gap;
    return mean;
}

/// The masses at a fragment whose step is that of an end. Where several fragments may share the step, moments cannot tell them
/// apart. In the pixel's own interval this holds for each end; otherwise only if one step holds both ends.
FN QueryMasses masses_at_end(IN(QueryMasses) masses, int end, bool own_interval)
{
    bool none_in_front = end == AT_BOTH_ENDS || (end == AT_NEAR_END && own_interval);
    bool none_behind = end == AT_BOTH_ENDS || (end == AT_FAR_END && own_interval);
    float in_front = none_in_front ? 0.0f : masses.in_front;
    return make_masses(in_front, none_behind ? 1.0f - in_front : masses.at_query);
}

/// What is known of a fragment. own: its absorbance; 0 for a query that does not belong to a fragment. end: AT_NEAR_END and so on; AT_NO_END if the
/// ends are not known. estimate: ESTIMATE_BETA and so on. beta in [0, 1].
///
/// A fragment at one end is taken to be alone there: as little lies in front of it, or as much, as its bounds allow.
FN FragmentEstimate estimate_at(IN(QueryMasses) masses, float b0, float own, int end, int estimate, float beta)
{
    FragmentEstimate result;
    float others = max(b0 - own, 0.0f);
    PRECISE float in_front = b0 * number_in_unit_range(masses.in_front);
    PRECISE float here = b0 * number_in_unit_range(masses.at_query) - own;
    float lower = min(in_front, others);
    float upper = min(lower + max(here, 0.0f), others);
    float gap = upper - lower;
    PRECISE float fraction = masses.in_front + beta * masses.at_query;
    PRECISE float published = b0 * number_in_unit_range(fraction);
    PRECISE float between = lower + beta * gap;
    bool at_one_end = end == AT_NEAR_END || end == AT_FAR_END;
    float greatest = transmittance_of(lower);
    float through = portable_exp(-gap);
    PRECISE float least = greatest * through;
    float transmittance = 1.0f;
    if (estimate == ESTIMATE_EXPECTED) transmittance = greatest * mean_through(gap, through);
    else transmittance = transmittance_of(estimate == ESTIMATE_BETA && end == AT_NO_END ? published : between);
    transmittance = at_one_end ? (end == AT_NEAR_END ? greatest : least) : transmittance;
    PRECISE float spread = transmittance * (greatest - least);
    result.lower = lower;
    result.upper = upper;
    result.transmittance = transmittance;
    result.spread = at_one_end ? 0.0f : spread;
    return result;
}

/// The absorbance in front of a query that does not belong to a fragment, for curves. bounds: result of estimate_at. estimate, beta: as
/// there. -ln T would lose the digits of absorbances above 87.
FN float estimated_absorbance(IN(FragmentEstimate) bounds, int estimate, float beta)
{
    float gap = bounds.upper - bounds.lower;
    PRECISE float between = bounds.lower + beta * gap;
    PRECISE float mean = bounds.lower - portable_log(mean_through(gap, portable_exp(-gap)));
    return estimate == ESTIMATE_EXPECTED ? mean : between;
}
