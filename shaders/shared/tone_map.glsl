// tone_map.glsl -- from linear colour, which has no upper end, to what a screen can show.

/// curve: 0 none, 1 Reinhard, 2 filmic, as the registry of parameters lists them. linear >= 0 per channel; the result is
/// not cut at 1.
FN float tone_mapped(float linear, int curve)
{
    if (curve == 1) return linear / (1.0f + linear);
    if (curve == 2) return linear * (2.51f * linear + 0.03f) / (linear * (2.43f * linear + 0.59f) + 0.14f);
    return linear;
}
