// vertex_array.hpp -- how vertices lie in buffers, and drawing them.
#pragma once
#include <cstddef>
#include <initializer_list>

#include "core/gl/handle.hpp"

namespace momentscope {

/// An attribute of a vertex: its number in the shader, how many floats it has, and where they begin.
struct VertexAttribute {
    GLuint number;
    int floats;
    std::size_t offset;
};

/// Vertices that lie one after another in a buffer, and the indices of triangles.
GlVertexArray make_vertex_array(GLuint vertices, std::size_t vertex_bytes,
                                std::initializer_list<VertexAttribute> attributes, GLuint indices);

/// Draws the triangles of some indices of an array, with the program in use.
void draw_triangles(GLuint vertex_array, std::size_t first_index, std::size_t index_count);

/// Draws the triangle of fullscreen.vert with the program in use.
void draw_fullscreen();

}  // namespace momentscope
