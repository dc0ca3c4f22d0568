// tone_map.glsl -- maps linear colours, which have no upper limit, to what a screen can show.

/// One channel of a colour. linear >= 0. curve: 0 none, 1 Reinhard, 2 filmic, as in the registry of parameters. The result is not
/// clamped to 1.
FN float tone_mapped(float linear, int curve)
{
    if (curve == 1) return linear / (1.0f + linear);
    if (curve == 2) return linear * (2.51f * linear + 0.03f) / (linear * (2.43f * linear + 0.59f) + 0.14f);
    return linear;
}
