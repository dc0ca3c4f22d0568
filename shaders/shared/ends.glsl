// ends.glsl -- the ends of a ray: the depths of the nearest and of the farthest fragment of a pixel, in 16 bits each. All of the
// absorbance lies between them.

/// The number of steps into which the ends divide the depth range [-1, 1].
const float END_STEPS = 65535.0f;

/// Fragments that absorb less do not move the ends. Otherwise a trace of smoke far in front of everything would stretch the
/// interval. Where such fragments lie beyond an end, the result is wrong by no more than the absorbance of all of them.
const float MIN_END_ABSORBANCE = 3.90625e-3f;   // 2^-8

/// What a pixel stores: two whole numbers in [0, END_STEPS], both of which are maximised. near counts steps from depth 1 down to
/// the nearest fragment, far from depth -1 up to the farthest. Both are rounded up, so the interval never misses a fragment. Both
/// are 0 if there was none.
struct Ends { float near; float far; };

FN Ends make_ends(float near, float far)
{
    Ends ends;
    ends.near = near;
    ends.far = far;
    return ends;
}

/// The step of an end: a distance in [0, 2] from the other side of the depth range, rounded up.
FN float end_step(float distance)
{
    PRECISE float steps = distance * (0.5f * END_STEPS);
    PRECISE float whole = floor(steps);
    return min(steps > whole ? whole + 1.0f : whole, END_STEPS);
}

/// The steps of a depth in [-1, 1].
FN Ends ends_of_depth(float depth)
{
    return make_ends(end_step(1.0f - depth), end_step(1.0f + depth));
}

/// What a fragment adds to the ends of its pixel.
FN Ends fragment_ends(float depth, float absorbance)
{
    Ends ends = ends_of_depth(depth);
    bool counts = absorbance >= MIN_END_ABSORBANCE;
    return make_ends(counts ? ends.near : 0.0f, counts ? ends.far : 0.0f);
}

/// What a pixel stores after one more fragment: what MAX blending does.
FN Ends with_ends(IN(Ends) stored, IN(Ends) fragment)
{
    return make_ends(max(stored.near, fragment.near), max(stored.far, fragment.far));
}

/// True if no fragment has set the ends. For any depth, near and far together have at least END_STEPS.
FN bool ends_unknown(IN(Ends) ends)
{
    return ends.near + ends.far < END_STEPS;
}

/// The depth of the near end, at most that of the nearest fragment.
FN float near_depth(IN(Ends) ends)
{
    PRECISE float depth = 1.0f - ends.near * (2.0f / END_STEPS);
    return depth;
}

/// The depth of the far end, at least that of the farthest fragment.
FN float far_depth(IN(Ends) ends)
{
    PRECISE float depth = ends.far * (2.0f / END_STEPS) - 1.0f;
    return depth;
}

/// A depth in the pixel's own interval: the near end is mapped to -1 and the far end to 1. depth beyond an end is mapped to it. If
/// the ends are unknown, the interval is the whole depth range.
FN float depth_in_interval(float depth, IN(Ends) ends)
{
    PRECISE float width = max(ends.near + ends.far - END_STEPS, 1.0f) * (2.0f / END_STEPS);
    PRECISE float place = (depth - near_depth(ends)) / width * 2.0f - 1.0f;
    return ends_unknown(ends) ? depth : clamp(place, -1.0f, 1.0f);
}

const int AT_NO_END = 0;
const int AT_NEAR_END = 1;
const int AT_FAR_END = 2;
const int AT_BOTH_ENDS = 3;

/// The end whose step holds the depth of a fragment. A fragment beyond an end counts as at it. Its own steps need not be rounded up:
/// ceil(x) >= n means x > n - 1.
FN int end_at(float depth, IN(Ends) ends)
{
    PRECISE float to_near = (1.0f - depth) * (0.5f * END_STEPS);
    PRECISE float to_far = (1.0f + depth) * (0.5f * END_STEPS);
    bool near = to_near > ends.near - 1.0f;
    bool far = to_far > ends.far - 1.0f;
    int end = near ? (far ? AT_BOTH_ENDS : AT_NEAR_END) : (far ? AT_FAR_END : AT_NO_END);
    return ends_unknown(ends) ? AT_NO_END : end;
}
