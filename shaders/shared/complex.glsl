// complex.glsl -- complex numbers.

struct Complex { float re; float im; };

FN Complex make_complex(float re, float im)
{
    Complex result;
    result.re = re;
    result.im = im;
    return result;
}

/// One of two numbers. WebGL has no `? :` for structs.
FN Complex choose_complex(bool first, IN(Complex) a, IN(Complex) b)
{
    return make_complex(first ? a.re : b.re, first ? a.im : b.im);
}

FN Complex product(IN(Complex) a, IN(Complex) b)
{
    PRECISE float re = a.re * b.re - a.im * b.im;
    PRECISE float im = a.re * b.im + a.im * b.re;
    return make_complex(re, im);
}

FN Complex conjugate(IN(Complex) a)
{
    Complex result;
    result.re = a.re;
    result.im = -a.im;
    return result;
}

/// Moves x, whose length is 1 except for rounding, closer to the unit circle: removes at least half of the rounding error. This is
/// one step of Newton's method for 1 / |x|.
FN Complex on_unit_circle(IN(Complex) x)
{
    PRECISE float excess = (x.re * x.re - 1.0f) + x.im * x.im;
    PRECISE float re = x.re - 0.5f * excess * x.re;
    PRECISE float im = x.im - 0.5f * excess * x.im;
    return make_complex(re, im);
}
