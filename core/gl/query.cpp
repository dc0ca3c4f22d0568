#include "core/gl/query.hpp"

namespace momentscope {

GlQuery make_query() {
    GLuint name = 0;
    glGenQueries(1, &name);
    return GlQuery(name);
}

void begin_any_fragment(GLuint query) {
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
}

void end_any_fragment() {
    glEndQuery(GL_ANY_SAMPLES_PASSED);
}

bool any_fragment(GLuint query) {
    GLuint any = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
    return any != 0;
}

void begin_time(GLuint query) {
    glBeginQuery(GL_TIME_ELAPSED, query);
}

void end_time() {
    glEndQuery(GL_TIME_ELAPSED);
}

double milliseconds(GLuint query) {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    return 1e-6 * static_cast<double>(nanoseconds);
}

void finish_gl() {
    glFinish();
}

}  // namespace momentscope
