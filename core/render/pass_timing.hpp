// pass_timing.hpp -- how long the GL takes for what it is told to draw.
#pragma once
#include <chrono>

#include "core/gl/gl_info.hpp"
#include "core/gl/handle.hpp"

namespace momentscope {

/// By the GL's own timer queries, or by a clock, waiting for the GL before and after.
enum class PassTiming { queries, finish };

/// The one that tells the truth. Rasterisers on the CPU answer queries with the time in which they fill
/// pixels and leave out what they do with vertices before (docs/benchmarking.md).
PassTiming reliable_timing(const GlInfo& gl);

/// "GL timer queries" or "from glFinish to glFinish".
const char* timing_text(PassTiming timing);

/// Takes the time from its construction on. Only one may live at a time.
class PassTimer {
public:
    /// query: of GL_TIME_ELAPSED.
    PassTimer(PassTiming timing, GLuint query);
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// Ends it, waiting for the GL. Call once.
    double milliseconds();

private:
    PassTiming timing_;
    GLuint query_;
    bool running_ = true;
    std::chrono::steady_clock::time_point begin_;
};

}  // namespace momentscope
