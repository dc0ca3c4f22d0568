// low_resolution.glsl -- how a pixel of the picture reads moments of a lower resolution: by bilinear interpolation of four of their
// pixels (Sharpe 2018, Section 4.1).

/// Interpolate between the columns first and second, which are neighbours unless the border clamps one of them. share in [0, 1):
/// the weight of the second. The same holds for rows.
struct Between { int first; int second; float share; };

/// pixel: column or row in the picture. extent: width or height of the picture. low_extent: the same of the moments.
FN Between between_low(int pixel, int extent, int low_extent)
{
    PRECISE float at = (float(pixel) + 0.5f) * float(low_extent) / float(extent) - 0.5f;
    float whole = floor(at);
    Between result;
    result.first = max(int(whole), 0);
    result.second = min(int(whole) + 1, low_extent - 1);
    result.share = at - whole;
    return result;
}

/// The width or height of the moments for a picture of that width or height. divisor: 1, 2, 4 or 8.
FN int low_extent_of(int extent, int divisor)
{
    return (extent + divisor - 1) / divisor;
}
