// query.hpp -- what the GL counts while it draws.
#pragma once
#include "core/gl/handle.hpp"

namespace momentscope {

GlQuery make_query();

/// Asks whether any fragment passes its tests between begin and end.
void begin_any_fragment(GLuint query);
void end_any_fragment();

/// Waits for the GL.
bool any_fragment(GLuint query);

/// Measures the time between begin and end.
void begin_time(GLuint query);
void end_time();

/// Waits for the GL.
double milliseconds(GLuint query);

/// Waits until the GL has drawn everything.
void finish_gl();

}  // namespace momentscope
