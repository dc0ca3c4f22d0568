#include "core/gl/pass_timing.hpp"

#include "core/gl/query.hpp"

namespace momentscope {

PassTiming reliable_timing(const GlInfo& gl) {
    return gl.software || !gl.can.timer_queries ? PassTiming::finish : PassTiming::queries;
}

const char* timing_text(PassTiming timing) {
    return timing == PassTiming::queries ? "GL timer queries" : "from glFinish to glFinish";
}

PassTimer::PassTimer(PassTiming timing, GLuint query) : timing_(timing), query_(query) {
    if (timing_ == PassTiming::queries) {
        begin_time(query_);
    } else {
        finish_gl();
        begin_ = std::chrono::steady_clock::now();
    }
}

// The query must also end after a failure; otherwise the next picture could not begin one.
PassTimer::~PassTimer() {
    if (running_ && timing_ == PassTiming::queries) end_time();
}

double PassTimer::milliseconds() {
    running_ = false;
    if (timing_ == PassTiming::queries) {
        end_time();
        return momentscope::milliseconds(query_);
    }
    finish_gl();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace momentscope
