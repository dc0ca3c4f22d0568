#include "core/gl/buffer.hpp"

#include <algorithm>
#include <cstring>

namespace momentscope {

namespace {

// GL does not accept empty storage, and a scene without objects has buffers, too.
constexpr std::size_t LEAST_BYTES = 4;

}  // namespace

GlBuffer make_buffer(std::size_t bytes) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    GlBuffer buffer(name);
    glBindBuffer(GL_COPY_WRITE_BUFFER, name);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(std::max(bytes, LEAST_BYTES)), nullptr,
                 GL_DYNAMIC_DRAW);
    return buffer;
}

// This kind of buffer is bound to a vertex array.
GlBuffer make_index_buffer(std::span<const std::uint32_t> indices) {
    GLuint names[2] = {};
    glGenVertexArrays(1, &names[0]);
    glGenBuffers(1, &names[1]);
    const GlVertexArray array(names[0]);
    GlBuffer buffer(names[1]);
    glBindVertexArray(array);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(std::max(indices.size_bytes(), LEAST_BYTES)), nullptr,
                 GL_DYNAMIC_DRAW);
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(indices.size_bytes()),
                    indices.data());
    glBindVertexArray(0);
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
