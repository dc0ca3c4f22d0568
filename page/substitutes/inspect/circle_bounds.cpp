// circle_bounds.cpp -- the browser edition has no solver of linear programs.
#include "core/inspect/circle_bounds.hpp"

#include "core/support/error.hpp"

namespace momentscope {

std::optional<SharpBounds> circle_bounds(const ViewRay&, int, double, std::span<const float>,
                                         const std::stop_token&) {
    throw Error(
        "The sharp bounds of trigonometric moments take linear programs, which the browser edition does not "
        "solve; use power moments, or the program on a computer.");
}

}  // namespace momentscope
