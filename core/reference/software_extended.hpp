// software_extended.hpp -- numbers in software with the 64 bits of the long double of x86.
#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace momentscope::reference {

/// Sums, products, quotients and square roots have the same bits as those of an 80-bit long double.
using SoftwareExtended = boost::multiprecision::cpp_bin_float_double_extended;

}  // namespace momentscope::reference
