#include "core/ray/submission_order.hpp"

#include <algorithm>
#include <numeric>

namespace momentscope {

SubmissionOrder submission_order(const ParameterValues& values) {
    return {values.get<OrderKind>(), static_cast<std::uint32_t>(values.count(ParameterId::order_seed))};
}

std::vector<std::uint32_t> ordered_numbers(std::size_t count, OrderKind kind, RandomNumbers& random) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    if (kind == OrderKind::reversed) std::ranges::reverse(numbers);
    for (std::size_t i = count; kind == OrderKind::shuffled && i > 1; --i)
        std::swap(numbers[i - 1],
                  numbers[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    return numbers;
}

namespace {

void submit_in(std::vector<Fragment>& fragments, const SubmissionOrder& order, RandomNumbers& random) {
    const std::vector<Fragment> before = fragments;
    const auto numbers = ordered_numbers(before.size(), order.kind, random);
    for (std::size_t i = 0; i < numbers.size(); ++i) fragments[i] = before[numbers[i]];
}

}  // namespace

ViewRay submitted_in(ViewRay ray, const SubmissionOrder& order) {
    RandomNumbers random(order.seed);
    submit_in(ray.fragments, order, random);
    for (LowResolutionSource& share : ray.low_resolution_sources) submit_in(share.fragments, order, random);
    return ray;
}

}  // namespace momentscope
