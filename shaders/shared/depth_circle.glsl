// depth_circle.glsl -- maps depths to the unit circle, x(z) = exp(i phi) with phi = (z + 1)(pi - theta/2) (paper, Eq. 5). The
// wrapping zone is the arc of angle theta that holds no depths.

/// psi(x) of the paper, Section 5.2. It grows with the phase of x like an angle, from -1 at phase 0 to 7 at phase 2 pi, but needs
/// no inverse trigonometry.
FN float phase_order(IN(Complex) x)
{
    PRECISE float r = abs(x.im) - abs(x.re);
    r = x.re < 0.0f ? 2.0f - r : r;
    return x.im < 0.0f ? 6.0f - r : r;
}

/// Numbers that depend on theta but not on depth.
struct Basis
{
    float half_phase_scale;     // phi / 2 per (z + 1)
    float quarter_sine;         // sin(theta / 2), to turn half a phase by half of the wrapping zone
    float quarter_cosine;
    float ramp_scale;           // Eq. 6: in the wrapping zone, v = ramp_scale psi + ramp_offset
    float ramp_offset;
};

/// wrapping_zone_angle theta in [0, pi].
FN Basis make_basis(float wrapping_zone_angle)
{
    Basis basis;
    basis.half_phase_scale = 0.5f * PI - 0.25f * wrapping_zone_angle;
    SinCos half_zone = portable_sincos(0.5f * wrapping_zone_angle);
    basis.quarter_sine = half_zone.sine;
    basis.quarter_cosine = half_zone.cosine;
    Complex end = make_complex(half_zone.cosine, -half_zone.sine);   // exp(i (pi - theta/2)) but for its sign; squared below
    float zone_start = phase_order(product(end, end));
    PRECISE float ramp = 1.0f / (7.0f - zone_start);
    basis.ramp_scale = wrapping_zone_angle > 0.0f ? ramp : 0.0f;
    basis.ramp_offset = wrapping_zone_angle > 0.0f ? 1.0f - 7.0f * ramp : 0.0f;
    return basis;
}

/// A Basis as an array of numbers, for a uniform block.
#define BASIS_FLOATS 5
struct StoredBasis { float x[BASIS_FLOATS]; };

FN StoredBasis packed_basis(IN(Basis) basis)
{
    StoredBasis stored;
    stored.x[0] = basis.half_phase_scale;
    stored.x[1] = basis.quarter_sine;
    stored.x[2] = basis.quarter_cosine;
    stored.x[3] = basis.ramp_scale;
    stored.x[4] = basis.ramp_offset;
    return stored;
}

FN Basis unpacked_basis(IN(StoredBasis) stored)
{
    Basis basis;
    basis.half_phase_scale = stored.x[0];
    basis.quarter_sine = stored.x[1];
    basis.quarter_cosine = stored.x[2];
    basis.ramp_scale = stored.x[3];
    basis.ramp_offset = stored.x[4];
    return basis;
}

/// exp(i phi / 2) for a depth in [-1, 1].
FN Complex half_phase(float depth, IN(Basis) basis)
{
    SinCos half_angle = portable_sincos((depth + 1.0f) * basis.half_phase_scale);
    return make_complex(half_angle.cosine, half_angle.sine);
}
