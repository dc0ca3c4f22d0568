// low_resolution.glsl -- where a pixel of the picture reads moments that were made at a lower resolution: bilinearly between four
// of their pixels (Sharpe 2018, Section 4.1).

/// Between column and column + 1 (and so with rows), as far as these exist; share in [0, 1) of the second.
struct Between { int first; int second; float share; };

/// pixel: column or row in the picture of the given extent; low_extent: that of the moments.
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

/// Extent of the moments for a picture of that extent; divisor: 1, 2, 4 or 8.
FN int low_extent_of(int extent, int divisor)
{
    return (extent + divisor - 1) / divisor;
}
