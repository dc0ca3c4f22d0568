// buffer.hpp -- buffers: making, writing, reading, binding to blocks of shaders.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A buffer of this size, with undefined contents.
GlBuffer make_buffer(std::size_t bytes);

/// A buffer that holds these values.
template <typename T>
GlBuffer make_buffer_of(std::span<const T> values);

/// A buffer with the indices of triangles. Browsers want to know what they are for when they are made.
GlBuffer make_index_buffer(std::span<const std::uint32_t> indices);

/// Replaces the bytes from `offset` on.
void write_buffer(GLuint buffer, std::size_t offset, std::span<const std::byte> bytes);

/// Replaces the start of a buffer.
template <typename T>
void write_buffer(GLuint buffer, const T& value) {
    write_buffer(buffer, 0, std::as_bytes(std::span(&value, 1)));
}

/// Fills `bytes` from `offset` on. Waits for the GL.
void read_buffer(GLuint buffer, std::size_t offset, std::span<std::byte> bytes);

/// Binds a buffer, or a part of it, to a block of uniforms.
void bind_uniforms(GLuint block, GLuint buffer);
void bind_uniforms(GLuint block, GLuint buffer, std::size_t offset, std::size_t bytes);

/// Binds a buffer to a block that shaders may write. Needs OpenGL 4.3.
void bind_storage(GLuint block, GLuint buffer);

/// Makes what shaders wrote to images and storage visible to all that follows.
void finish_shader_writes();

template <typename T>
GlBuffer make_buffer_of(std::span<const T> values) {
    GlBuffer buffer = make_buffer(values.size_bytes());
    if (!values.empty()) write_buffer(buffer, 0, std::as_bytes(values));
    return buffer;
}

}  // namespace momentscope
