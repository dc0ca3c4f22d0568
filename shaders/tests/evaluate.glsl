// evaluate.glsl -- runs the shared source on a list of inputs. Only tests use it (tests/gl/bit_equality_test.cpp).
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#include "shared/storage.glsl"
#include "shared/reconstruction.glsl"
#include "shared/ends.glsl"
#include "shared/fragment_estimate.glsl"

struct Item
{
    float b0;
    float b[8];
    float depth;
    float view_depth;
    float opacity;
    float near_step;
    float far_step;
};

struct Result
{
    float absorbance;
    float transmittance;
    float warped;
    float b0_with_fragment;
    float b_with_fragment[8];
    float lower;
    float upper;
    float expected;
    float spread;
    float near_with_fragment;
    float far_with_fragment;
};

layout(std430, binding = 0) readonly buffer Items
{
    float beta;
    float theta;
    float alpha;
    float padding;
    float z_min;
    float z_max;
    float more_padding[2];
    Item items[];
};

layout(std430, binding = 1) writeonly buffer Results { Result results[]; };

/// What is known of a fragment, from moments of the pixel's own interval.
FragmentEstimate estimate_of_item(Item item, Moments moments)
{
    Ends ends = make_ends(item.near_step, item.far_step);
    float depth = depth_in_interval(item.depth, ends);
    BiasedMoments biased = biased_moments(moments, alpha);
    Factor factor = factor_moments(biased);
    Basis basis = make_basis(theta);
#ifdef SHARP_BOUNDS
    QueryMasses masses = sharp_masses(factor, factor_inner(biased), basis, depth);
#else
    QueryMasses masses = query_masses(reconstruct(factor, basis, depth));
#endif
    int end = end_at(item.depth, ends);
    return estimate_at(masses_at_end(masses, end, true), moments.b0, absorbance_of_opacity(item.opacity), end,
                       ESTIMATE_EXPECTED, beta);
}

void evaluate(uint index)
{
    Moments stored;
    stored.b0 = items[index].b0;
    for (int i = 0; i < MOMENT_FLOATS; ++i) stored.b[i] = items[index].b[i];
    Moments moments = unpacked_moments(stored);
    float absorbance =
        is_empty(moments) ? 0.0 : absorbance_from_moments(moments, items[index].depth, alpha, beta, theta);
    results[index].absorbance = absorbance;
    results[index].transmittance = transmittance_of(absorbance);
    float warped = warped_depth(items[index].view_depth, depth_warp_factors(z_min, z_max));
    results[index].warped = warped;
    Moments fragment = fragment_moments(warped, absorbance_of_opacity(items[index].opacity), make_basis(theta));
    Moments sum = with_fragment(stored, fragment);
    results[index].b0_with_fragment = sum.b0;
    for (int i = 0; i < MOMENT_FLOATS; ++i) results[index].b_with_fragment[i] = sum.b[i];
    FragmentEstimate estimate = estimate_at(make_masses(0.0, 0.0), 0.0, 0.0, AT_NO_END, ESTIMATE_EXPECTED, beta);
    if (!is_empty(moments)) estimate = estimate_of_item(items[index], moments);
    results[index].lower = estimate.lower;
    results[index].upper = estimate.upper;
    results[index].expected = estimate.transmittance;
    results[index].spread = estimate.spread;
    Ends ends = with_ends(make_ends(items[index].near_step, items[index].far_step),
                          fragment_ends(warped, absorbance_of_opacity(items[index].opacity)));
    results[index].near_with_fragment = ends.near;
    results[index].far_with_fragment = ends.far;
}
