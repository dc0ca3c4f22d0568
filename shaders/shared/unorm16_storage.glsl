// unorm16_storage.glsl -- moments stored in 16 bits each (supplementary, Section 2). They are divided by b_0 and moved into [0, 1]
// by an affine transform. So blending cannot sum fragments; they are read, added and written in order. b_0 is a half float.
#include "rounding.glsl"

/// The linear part of the transform, or its inverse if `back`. Being linear, it may be applied to moments that are not normalised.
/// For power moments it is that of Theta*_m. For bases that make good use of [-1, 1] as they are, the transform is b/2 + 1/2.
FN Moments transformed(IN(Moments) moments, bool back)
{
    Moments result;
    result.b0 = moments.b0;
#ifdef THETA_TRANSFORM
    UNROLL
    for (int i = 0; i < ROOT_COUNT; ++i)
    {
        PRECISE float odd = 0.0f;
        PRECISE float even = 0.0f;
        UNROLL
        for (int j = 0; j < ROOT_COUNT; ++j)
        {
            int at = i * ROOT_COUNT + j;
            odd = odd + (back ? THETA_ODD_INVERSE[at] : THETA_ODD[at]) * moments.b[2 * j];
            even = even + (back ? THETA_EVEN_INVERSE[at] : THETA_EVEN[at]) * moments.b[2 * j + 1];
        }
        result.b[2 * i] = odd;
        result.b[2 * i + 1] = even;
    }
#else
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i) result.b[i] = (back ? 2.0f : 0.5f) * moments.b[i];
#endif
    return result;
}

/// The constant that the transform adds to number i.
FN float transform_offset(int i)
{
#ifdef THETA_TRANSFORM
    return i % 2 == 0 ? 0.5f : THETA_EVEN_OFFSET[i / 2];
#else
    return 0.5f;
#endif
}

/// What a pixel stores after one more fragment: b0, and b[i] in [0, 1]. stored: what it stored before; 0 at first. fragment: result
/// of fragment_moments (supplementary, Section 2, last equation).
FN Moments with_fragment(IN(Moments) stored, IN(Moments) fragment)
{
    Moments added = transformed(fragment, false);
    PRECISE float b0 = stored.b0 + fragment.b0;
    Moments sum;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        PRECISE float before = stored.b0 * (rounded_to_unorm16(stored.b[i]) - transform_offset(i));
        PRECISE float after = (before + added.b[i]) / max(b0, 1.0e-30f) + transform_offset(i);
        sum.b[i] = rounded_to_unorm16(after);
    }
    sum.b0 = rounded_to_half(b0);
    return sum;
}

/// The moments that the stored numbers represent, not normalised.
FN Moments unpacked_moments(IN(Moments) stored)
{
    Moments scaled;
    scaled.b0 = stored.b0;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        PRECISE float normalised = rounded_to_unorm16(stored.b[i]) - transform_offset(i);
        scaled.b[i] = stored.b0 * normalised;
    }
    return transformed(scaled, true);
}
