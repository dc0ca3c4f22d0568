// pixel_state.glsl -- what a pixel stores with a technique without moments: an array of MAX_STATE_FLOATS numbers. The math file of
// the technique defines this constant, and these macros, before it includes this file.
// One macro says how the states of fragments are accumulated:
//   STATE_SUMS     they are summed, by additive blending
//   STATE_OVER     they are composited over the stored state, by alpha blending
//   STATE_ORDERED  with_fragment changes the stored state, one fragment after another
//   STATE_SAMPLES  f[0] is summed; of all other numbers the least is kept
//   STATE_NEAREST  the state with the least f[3] is kept; if several have it, the latest of them
// HOLDS_COLORS: the state contains the colour of the pixel, so there is no second pass.
// WITHOUT_DEPTHS: the state does not define a transmittance at a depth.

struct PixelState { float f[MAX_STATE_FLOATS]; };

// The parameters that the technique reads: before it includes this file, it defines SETTINGS(S) as S(type, id) for each of them. An
// id is that of a row in core/parameters/parameters.def. Types are int (also for a choice), bool and float. Shaders read floats from
// a uniform block, so that dragging a slider compiles no shader; only beta and alpha are there.
#ifdef SETTINGS
#define MEMBER(type, id) type id;
struct PixelStateSettings { SETTINGS(MEMBER) };
#else
struct PixelStateSettings { int none; };   // GLSL has no empty structs
#endif

/// One transparent fragment. depth: 0 at the near end of the depth range and 1 at its far end. window_depth: as in the depth
/// buffer. plane_depth: the logarithmic depth from the near plane, 0, to the far plane, 1. Colours are not multiplied by opacity.
/// seed: see random_bits.glsl. threshold: see alpha_threshold.glsl.
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

/// The colour of all fragments as far as it is seen, and the total transmittance.
struct Composited { float red; float green; float blue; float transmittance; };

/// A state of zeros.
FN PixelState zero_state()
{
    PixelState state;
    UNROLL
    for (int i = 0; i < MAX_STATE_FLOATS; ++i) state.f[i] = 0.0f;
    return state;
}

/// The result for states that hold no colour.
FN Composited transparent(float transmittance)
{
    Composited result;
    result.red = 0.0f;
    result.green = 0.0f;
    result.blue = 0.0f;
    result.transmittance = transmittance;
    return result;
}

/// The depth that a perspective projection writes to the depth buffer, in [0, 1]: 0 at the near plane and nearer, 1 at the far
/// plane and farther. Computed from quotients of depths, which stay finite for all floats; products may overflow. 0 < near < far.
FN float window_depth_of(float view_depth, float near, float far)
{
    float depth = clamp(view_depth, near, far);
    return (1.0f - near / depth) / (1.0f - near / far);
}

/// The logarithmic depth: 0 at the near plane, 1 at the far plane (Sharpe 2018, Equation 6).
FN float plane_depth_of(float view_depth, float near, float far)
{
    float near_log = portable_log(near);
    return clamp((portable_log(view_depth) - near_log) / (portable_log(far) - near_log), 0.0f, 1.0f);
}
