// version.hpp -- which Momentscope this is.
#pragma once

namespace momentscope {

/// The version, and behind a plus sign the commit that was built where git knows it: "0.1.0+bc54233".
extern const char* const PROGRAM_VERSION;

}  // namespace momentscope
