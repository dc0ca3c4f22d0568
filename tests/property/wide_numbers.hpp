// wide_numbers.hpp -- takes the numbers of the exact curve to numbers with more digits.
#pragma once
#include "core/reference/double_double.hpp"

namespace momentscope::test {

/// The same number in `Wide`.
template <class Wide, class Number>
Wide widened(const Number& number) {
    return Wide(number);
}
template <class Wide>
Wide widened(const reference::DoubleDouble& number) {
    return Wide(number.high) + number.low;
}

}  // namespace momentscope::test
