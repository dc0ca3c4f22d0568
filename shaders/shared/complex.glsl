// complex.glsl -- complex numbers.

struct Complex { float re; float im; };

FN Complex make_complex(float re, float im)
{
    Complex result;
    result.re = re;
    result.im = im;
    return result;
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
