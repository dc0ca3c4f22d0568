// handle.hpp -- owners of GL object names, which delete the objects.
#pragma once
#include <glad/gl.h>

#include <utility>

namespace momentscope {

/// Owns one GL name; 0 means none. Must be destroyed while its context is current.
template <void (*destroy)(GLuint)>
class GlHandle {
public:
    GlHandle() = default;
    explicit GlHandle(GLuint name) : name_(name) {}
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GlHandle(const GlHandle&) = delete;
    GlHandle& operator=(const GlHandle&) = delete;
    ~GlHandle() {
        if (name_ != 0) destroy(name_);
    }
    operator GLuint() const {
        return name_;
    }  // NOLINT(google-explicit-constructor): reads like the GL name it is

private:
    GLuint name_ = 0;
};

namespace gl_destroy {
inline void texture(GLuint name) {
    glDeleteTextures(1, &name);
}
inline void buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
inline void framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}
inline void vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}
inline void program(GLuint name) {
    glDeleteProgram(name);
}
inline void shader(GLuint name) {
    glDeleteShader(name);
}
inline void query(GLuint name) {
    glDeleteQueries(1, &name);
}
}  // namespace gl_destroy

using GlTexture = GlHandle<gl_destroy::texture>;
using GlBuffer = GlHandle<gl_destroy::buffer>;
using GlFramebuffer = GlHandle<gl_destroy::framebuffer>;
using GlVertexArray = GlHandle<gl_destroy::vertex_array>;
using GlProgram = GlHandle<gl_destroy::program>;
using GlShader = GlHandle<gl_destroy::shader>;
using GlQuery = GlHandle<gl_destroy::query>;

}  // namespace momentscope
