#include "core/gl/buffer.hpp"

#include <algorithm>
#include <cstring>

namespace momentscope {

// GL does not accept empty storage, and a scene without objects has buffers, too.
GlBuffer make_buffer(std::size_t bytes) {
    constexpr std::size_t LEAST = 4;
    GLuint name = 0;
    glGenBuffers(1, &name);
    GlBuffer buffer(name);
    glBindBuffer(GL_COPY_WRITE_BUFFER, name);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(std::max(bytes, LEAST)), nullptr,
                 GL_DYNAMIC_DRAW);
    return buffer;
}

void write_buffer(GLuint buffer, std::size_t offset, std::span<const std::byte> bytes) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void read_buffer(GLuint buffer, std::size_t offset, std::span<std::byte> bytes) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    const void* const mapped = glMapBufferRange(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset),
                                                static_cast<GLsizeiptr>(bytes.size()), GL_MAP_READ_BIT);
    if (mapped != nullptr) std::memcpy(bytes.data(), mapped, bytes.size());
    glUnmapBuffer(GL_COPY_READ_BUFFER);
}

void bind_uniforms(GLuint block, GLuint buffer) {
    glBindBufferBase(GL_UNIFORM_BUFFER, block, buffer);
}

void bind_uniforms(GLuint block, GLuint buffer, std::size_t offset, std::size_t bytes) {
    glBindBufferRange(GL_UNIFORM_BUFFER, block, buffer, static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes));
}

void bind_storage(GLuint block, GLuint buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, block, buffer);
}

void finish_shader_writes() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace momentscope
