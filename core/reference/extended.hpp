// extended.hpp -- the numbers of the exact curve: at least 64 bits on every platform.
#pragma once
#include <cfloat>

#if LDBL_MANT_DIG >= 64 && !defined(MOMENTSCOPE_NARROW_LONG_DOUBLE)

namespace momentscope::reference {
using Extended = long double;
}

#else  // a long double is only a double, as with Apple's arm64, or the build behaves as if it were
#include "core/reference/software_extended.hpp"

namespace momentscope::reference {
using Extended = SoftwareExtended;
}

#endif
