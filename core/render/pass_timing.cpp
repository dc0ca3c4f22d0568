#include "core/render/pass_timing.hpp"

namespace momentscope {

PassTiming reliable_timing(const GlInfo& gl) {
    return gl.software ? PassTiming::finish : PassTiming::queries;
}

const char* timing_text(PassTiming timing) {
    return timing == PassTiming::queries ? "GL timer queries" : "from glFinish to glFinish";
}

PassTimer::PassTimer(PassTiming timing, GLuint query) : timing_(timing), query_(query) {
    if (timing_ == PassTiming::queries) {
        glBeginQuery(GL_TIME_ELAPSED, query_);
    } else {
        glFinish();
        begin_ = std::chrono::steady_clock::now();
    }
}

// The query must also end after a failure; otherwise the next picture could not begin one.
PassTimer::~PassTimer() {
    if (running_ && timing_ == PassTiming::queries) glEndQuery(GL_TIME_ELAPSED);
}

double PassTimer::milliseconds() {
    running_ = false;
    if (timing_ == PassTiming::queries) {
        glEndQuery(GL_TIME_ELAPSED);
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
        return 1e-6 * static_cast<double>(nanoseconds);
    }
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace momentscope
