// moments_needed.hpp -- the fewest moments that a pixel needs: as the bounds say, without the truth, and as
// the actual error says.
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Techniques of one basis with bounds, with 32 bits per moment, in ascending order of moments: four, six,
/// eight.
constexpr std::size_t ORDER_COUNT = 3;
using MomentOrders = std::array<const Technique*, ORDER_COUNT>;

/// The techniques of a basis: power or chebyshev. Throws Error for all others, because on the circle beta = 0
/// and beta = 1 are not bounds.
MomentOrders moment_orders(std::string_view basis);

/// How uncertain T is at the depths of the fragments, at most. This is the difference between its bounds,
/// less the part that the absorbance at the depth itself causes, which is not uncertain. In [0, 1], also if
/// rounding or bias puts the bounds closer together than they can be. The fragments must be known, but not
/// what lies in front of them.
double certified_gap(const ViewRay& ray, const Technique& technique, const ParameterValues& values);

/// The greatest error of T at the depths of the fragments. The truth includes beta times the absorbance at
/// the depth itself: self-occlusion is a choice, which renormalisation compensates for, and not a lack of
/// moments.
double greatest_error(const ViewRay& ray, const Technique& technique, const ParameterValues& values);

/// What a pixel needs. nothing: it has no fragments. more: not even eight moments are enough.
enum class Needed : unsigned char { nothing, four, six, eight, more };
constexpr std::size_t NEEDED_COUNT = 5;
std::string needed_text(Needed needed);

struct PixelNeed {
    Needed by_certificate = Needed::nothing;
    Needed by_error = Needed::nothing;
    friend bool operator==(const PixelNeed&, const PixelNeed&) = default;
};

/// The first of the orders with a certified gap, or an error, of at most the tolerance epsilon in `values`.
PixelNeed pixel_need(const ViewRay& ray, const MomentOrders& orders, const ParameterValues& values);

/// The number of pixels by what they need.
struct NeedHistogram {
    std::array<long, NEEDED_COUNT> by_certificate{}, by_error{};
    long cautious = 0;    // pixels with by_certificate > by_error
    long overlooked = 0;  // pixels with by_certificate < by_error: no bound includes bias and rounding
};
NeedHistogram count_needs(std::span<const PixelNeed> pixels);

/// The memory that a picture would need, relative to eight moments in every pixel, if each square tile of
/// pixels stored only as many moments as its most demanding pixel needs by the certificate, and none without
/// fragments. In [0, 1].
double tiled_memory(std::span<const PixelNeed> pixels, int width, int tile);

}  // namespace momentscope
