// pass_timing.hpp -- measures how long the GL takes to draw.
#pragma once
#include <chrono>

#include "core/gl/gl_info.hpp"
#include "core/gl/handle.hpp"

namespace momentscope {

/// By timer queries of the GL, or by a clock, after waiting for the GL before and after drawing.
enum class PassTiming { queries, finish };

/// The kind of timing that is right on this GL. Rasterisers on the CPU answer a query with the time in which
/// they fill pixels, and leave out the time for vertices before that (docs/benchmarking.md).
PassTiming reliable_timing(const GlInfo& gl);

/// "GL timer queries" or "from glFinish to glFinish".
const char* timing_text(PassTiming timing);

/// Measures the time from its construction. Only one may exist at a time.
class PassTimer {
public:
    /// query: of make_query.
    PassTimer(PassTiming timing, GLuint query);
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// Waits for the GL, ends the measurement and returns its time. Call it once.
    double milliseconds();

private:
    PassTiming timing_;
    GLuint query_;
    bool running_ = true;
    std::chrono::steady_clock::time_point begin_;
};

}  // namespace momentscope
