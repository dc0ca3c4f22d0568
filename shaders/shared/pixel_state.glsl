// pixel_state.glsl -- what a pixel stores under a technique without moments: up to MAX_STATE_FLOATS numbers, which the math
// file defines before it includes this. A math file says with one of
//   STATE_SUMS     states of fragments are summed, by additive blending
//   STATE_OVER     states of fragments are put over what is there, by alpha blending
//   STATE_ORDERED  with_fragment changes the state, fragment after fragment
//   STATE_SAMPLES  of states of fragments, f[0] is summed and of all others the least is kept
//   STATE_NEAREST  of states of fragments, that with the least f[3] is kept, and the latest of such
// how a state comes about, with HOLDS_COLORS that it contains the pixel's colour, so that there is no second pass, and with
// WITHOUT_DEPTHS that it knows no transmittance at a depth.

struct PixelState { float f[MAX_STATE_FLOATS]; };

// A technique whose parameters choose something defines HAS_SETTINGS and `struct PixelStateSettings` before it includes this; its
// twin in C++ is in core/techniques/pixel_state_settings.hpp.
#ifndef HAS_SETTINGS
struct PixelStateSettings { int none; };   // GLSL asks for a member
#endif

/// One transparent fragment. Depth is 0 at the near end of the depth range and 1 at its far end, window depth that of the
/// depth buffer, plane depth the same logarithmically; colour is not multiplied by opacity. seed: random_bits.glsl; threshold:
/// alpha_threshold.glsl.
struct PixelStateFragment
{
    float depth;
    float view_depth;
    float window_depth;
    float plane_depth;
    float opacity;
    float red;
    float green;
    float blue;
    uint seed;
    float threshold;
};

/// Colour of all fragments, multiplied by what is seen of it, and the transmittance of all.
struct Composited { float red; float green; float blue; float transmittance; };

/// Nothing but zeros.
FN PixelState zero_state()
{
    PixelState state;
    UNROLL
    for (int i = 0; i < MAX_STATE_FLOATS; ++i) state.f[i] = 0.0f;
    return state;
}

/// For states that hold no colour.
FN Composited transparent(float transmittance)
{
    Composited result;
    result.red = 0.0f;
    result.green = 0.0f;
    result.blue = 0.0f;
    result.transmittance = transmittance;
    return result;
}

/// Depth of the depth buffer of a perspective projection, in [0, 1]: 0 at the near plane and nearer, 1 at the far plane and
/// farther. Quotients of depths, unlike their products, stay finite for all floats; 0 < near < far.
FN float window_depth_of(float view_depth, float near, float far)
{
    float depth = clamp(view_depth, near, far);
    return (1.0f - near / depth) / (1.0f - near / far);
}

/// The logarithm of the depth from the near plane, 0, to the far plane, 1 (Sharpe 2018, Equation 6).
FN float plane_depth_of(float view_depth, float near, float far)
{
    float near_log = portable_log(near);
    return clamp((portable_log(view_depth) - near_log) / (portable_log(far) - near_log), 0.0f, 1.0f);
}
