// submission_order.hpp -- the order in which objects, triangles or the fragments of a ray are submitted.
#pragma once
#include "core/parameters/parameters.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope {

/// A value of ParameterId::order and, for a shuffled order, its seed.
struct SubmissionOrder {
    OrderKind kind = OrderKind::submitted;
    std::uint32_t seed = 1;
    friend bool operator==(const SubmissionOrder&, const SubmissionOrder&) = default;
};
SubmissionOrder submission_order(const ParameterValues& values);

/// The numbers 0 to count - 1 in this order.
std::vector<std::uint32_t> ordered_numbers(std::size_t count, OrderKind kind, RandomNumbers& random);

/// The ray with its fragments in this order, and those of its low-resolution sources, too.
ViewRay submitted_in(ViewRay ray, const SubmissionOrder& order);

}  // namespace momentscope
