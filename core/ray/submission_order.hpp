// submission_order.hpp -- the order in which objects, triangles or the fragments of a ray are submitted.
#pragma once
#include "core/parameters.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope {

/// Values of ParameterId::order; the seed is that of a shuffled one.
struct SubmissionOrder {
    OrderKind kind = OrderKind::submitted;
    std::uint32_t seed = 1;
    friend bool operator==(const SubmissionOrder&, const SubmissionOrder&) = default;
};
SubmissionOrder submission_order(const ParameterValues& values);

/// The numbers 0 to count - 1 in that order.
std::vector<std::uint32_t> ordered_numbers(std::size_t count, OrderKind kind, RandomNumbers& random);

/// The ray with its fragments, and those of its low-resolution sources, submitted in that order.
ViewRay submitted_in(ViewRay ray, const SubmissionOrder& order);

}  // namespace momentscope
