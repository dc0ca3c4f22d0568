// evaluate.glsl -- runs the shared source on a list of inputs. Only tests use it (tests/gl/bit_equality_test.cpp).
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#include "shared/storage.glsl"
#include "shared/reconstruction.glsl"

struct Item
{
    float b0;
    float b[8];
    float depth;
    float view_depth;
    float opacity;
};

struct Result
{
    float absorbance;
    float transmittance;
    float warped;
    float b0_with_fragment;
    float b_with_fragment[8];
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
}
