// method_fragment.glsl -- the fragment at hand as math files know it, and states as groups of four floats.

#define TEXEL(state, i) vec4(state.f[4 * (i)], state.f[4 * (i) + 1], state.f[4 * (i) + 2], state.f[4 * (i) + 3])
#define SET_TEXEL(state, i, texel)                                                                                     \
    {                                                                                                                  \
        vec4 four = texel;                                                                                             \
        state.f[4 * (i)] = four.x;                                                                                     \
        state.f[4 * (i) + 1] = four.y;                                                                                 \
        state.f[4 * (i) + 2] = four.z;                                                                                 \
        state.f[4 * (i) + 3] = four.w;                                                                                 \
    }

MethodSettings method_settings()
{
    MethodSettings settings;
    settings.size = METHOD_SIZE;
    settings.option = METHOD_OPTION;
    return settings;
}

#ifdef TRANSPARENT_FRAGMENT
MethodFragment method_fragment(vec3 color)
{
    MethodFragment fragment;
    fragment.view_depth = fragment_view_depth();
    fragment.depth = 0.5 * (fragment_depth() + 1.0);
    fragment.window_depth = window_depth_of(fragment.view_depth, frame.depth_warp.z, frame.depth_warp.w);
    fragment.opacity = object.color_opacity.a;
    fragment.red = color.r;
    fragment.green = color.g;
    fragment.blue = color.b;
    return fragment;
}
#endif
