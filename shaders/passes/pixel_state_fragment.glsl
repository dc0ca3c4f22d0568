// pixel_state_fragment.glsl -- the current fragment in the form that math files take, and states as groups of four floats.

/// The state with the i-th group of four floats replaced.
PixelState with_texel(PixelState state, int i, vec4 texel)
{
    state.f[4 * i] = texel.x;
    state.f[4 * i + 1] = texel.y;
    state.f[4 * i + 2] = texel.z;
    state.f[4 * i + 3] = texel.w;
    return state;
}

PixelStateSettings pixel_state_settings()
{
    return PixelStateSettings(PIXEL_STATE_SETTINGS);
}

#ifdef TRANSPARENT_FRAGMENT
PixelStateFragment pixel_state_fragment(vec3 color)
{
    PixelStateFragment fragment;
    fragment.view_depth = fragment_view_depth();
    fragment.depth = 0.5 * (fragment_depth() + 1.0);
    fragment.window_depth = window_depth_of(fragment.view_depth, frame.depth_warp.z, frame.depth_warp.w);
    fragment.plane_depth = plane_depth_of(fragment.view_depth, frame.depth_warp.z, frame.depth_warp.w);
    fragment.opacity = fragment_opacity();
    fragment.red = color.r;
    fragment.green = color.g;
    fragment.blue = color.b;
    fragment.seed = fragment_random_seed();
    fragment.threshold = fragment_threshold();
    return fragment;
}
#endif
