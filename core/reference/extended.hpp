// extended.hpp -- the numbers of the exact curve: at least 64 bits on every platform.
#pragma once
#include <cfloat>

#if LDBL_MANT_DIG == 64 && !defined(MOMENTSCOPE_NARROW_LONG_DOUBLE)

namespace momentscope::reference {
using Extended = long double;
}

#else  // a long double is a double or is computed in software, or the build behaves as if it were so
#include "core/reference/double_double.hpp"

namespace momentscope::reference {
using Extended = DoubleDouble;
}

#endif
