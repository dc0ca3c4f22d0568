// version.hpp -- the version of Momentscope.
#pragma once

namespace momentscope {

/// The version and, if git knows it, the commit after a plus sign: "0.1.0+bc54233".
extern const char* const PROGRAM_VERSION;

}  // namespace momentscope
