// threads.hpp -- whether this build can start threads. Pages without special headers cannot.
#pragma once

namespace momentscope {

#ifdef __EMSCRIPTEN__
constexpr bool HAS_THREADS = false;
#else
constexpr bool HAS_THREADS = true;
#endif

}  // namespace momentscope
