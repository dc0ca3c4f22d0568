// moments_needed.hpp -- the fewest moments that a pixel needs: told by the bounds alone, without the truth,
// and by the error that is really made.
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Techniques of one basis with bounds, in 32 bits, from the fewest moments to the most: four, six, eight.
constexpr std::size_t ORDER_COUNT = 3;
using MomentOrders = std::array<const Technique*, ORDER_COUNT>;

/// basis: power or chebyshev. Throws Error for others: on the circle beta = 0 and beta = 1 are not bounds.
MomentOrders moment_orders(std::string_view basis);

/// How far T is uncertain at the fragments' own depths, at most: the difference of its bounds, less what the
/// absorbance at that depth itself makes of it, which is no uncertainty. In [0, 1], never negative where
/// rounding or bias put bounds closer than they can be. It needs the fragments, but not what lies in front.
double certified_gap(const ViewRay& ray, const Technique& technique, const ParameterValues& values);

/// How far T is off at the fragments' own depths, at most. Of a fragment's own absorbance beta counts as in
/// front of it in the truth, too: self-occlusion is a choice, which renormalisation makes up for, and no lack
/// of moments.
double greatest_error(const ViewRay& ray, const Technique& technique, const ParameterValues& values);

/// Of a pixel: nothing for a pixel without fragments, `more` where not even eight moments are enough.
enum class Needed : unsigned char { nothing, four, six, eight, more };
constexpr std::size_t NEEDED_COUNT = 5;
std::string needed_text(Needed needed);

struct PixelNeed {
    Needed by_certificate = Needed::nothing;
    Needed by_error = Needed::nothing;
    friend bool operator==(const PixelNeed&, const PixelNeed&) = default;
};

/// The first of the orders whose gap, or error, is at most the tolerance epsilon of `values`.
PixelNeed pixel_need(const ViewRay& ray, const MomentOrders& orders, const ParameterValues& values);

/// How many pixels need what.
struct NeedHistogram {
    std::array<long, NEEDED_COUNT> by_certificate{}, by_error{};
    long cautious = 0;    // pixels for which the certificate asks for more than the error
    long overlooked = 0;  // for less: what bias and rounding add to the error is in no bound
};
NeedHistogram count_needs(std::span<const PixelNeed> pixels);

/// The share of the memory of eight moments that a picture would need if every square tile of pixels stored
/// no more than the most that one of its pixels needs by the certificate, and nothing where there are no
/// fragments. In [0, 1].
double tiled_memory(std::span<const PixelNeed> pixels, int width, int tile);

}  // namespace momentscope
