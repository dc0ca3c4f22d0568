// fragment.glsl -- the absorbance and the warped depth of one transparent fragment.

/// Opacities above this value are treated as this value, because -ln(1 - alpha_l) has no upper limit. The value is 1 - e^-10, so no
/// fragment absorbs more than 10, and no transmittance is off by more than 4.6e-5.
const float OPACITY_CAP = 0.9999546f;

/// Absorbance -ln(1 - alpha_l) of a fragment (paper, Section 3.1). opacity in [0, 1]; result in [0, 10].
FN float absorbance_of_opacity(float opacity)
{
    return negative_log_one_minus(clamp(opacity, 0.0f, OPACITY_CAP));
}

/// The transmittance of one fragment, for techniques that multiply transmittances. The cap is the same, so the result is at least
/// e^-10.
FN float transmittance_of_opacity(float opacity)
{
    return 1.0f - min(opacity, OPACITY_CAP);
}

/// T = exp(-A) for an absorbance A >= 0.
FN float transmittance_of(float absorbance)
{
    return portable_exp(-absorbance);
}

/// Maps view depths in [z_min, z_max] to [-1, 1], either logarithmically (paper, Section 3.3) or linearly (paper, Section 6). Both
/// are z = (place - origin) scale - 1. Logarithmically place = ln z_v and origin = ln z_min; linearly place = z_v and
/// origin = z_min.
struct DepthWarpFactors { float origin; float scale; bool linear; };

/// Logarithmic: z = 2 (ln z_v - ln z_min) / (ln z_max - ln z_min) - 1. z_min, z_max: view depths in scene units, 0 < z_min < z_max.
FN DepthWarpFactors depth_warp_factors(float z_min, float z_max)
{
    DepthWarpFactors warp;
    warp.origin = portable_log(z_min);
    warp.scale = 2.0f / (portable_log(z_max) - warp.origin);
    warp.linear = false;
    return warp;
}

/// Linear: z = 2 (z_v - z_min) / (z_max - z_min) - 1. z_min < z_max: view depths in scene units.
FN DepthWarpFactors linear_depth_factors(float z_min, float z_max)
{
    DepthWarpFactors warp;
    warp.origin = z_min;
    warp.scale = 2.0f / (z_max - z_min);
    warp.linear = true;
    return warp;
}

/// The depth in [-1, 1] of a view depth > 0. View depths outside of the range are clamped.
FN float warped_depth(float view_depth, IN(DepthWarpFactors) warp)
{
    float place = warp.linear ? view_depth : portable_log(view_depth);
    PRECISE float depth = (place - warp.origin) * warp.scale - 1.0f;
    return clamp(depth, -1.0f, 1.0f);
}

/// The view depth that warped_depth maps to `depth`, except for rounding.
FN float unwarped_depth(float depth, IN(DepthWarpFactors) warp)
{
    PRECISE float place = (depth + 1.0f) / warp.scale + warp.origin;
    return warp.linear ? place : portable_exp(place);
}
