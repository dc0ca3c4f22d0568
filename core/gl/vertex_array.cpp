#include "core/gl/vertex_array.hpp"

namespace momentscope {

namespace {

// The GL takes offsets as pointers.
const void* offset_pointer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace

GlVertexArray make_vertex_array(GLuint vertices, std::size_t vertex_bytes,
                                std::initializer_list<VertexAttribute> attributes, GLuint indices) {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    GlVertexArray array(name);
    glBindVertexArray(name);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    for (const VertexAttribute& attribute : attributes) {
        glEnableVertexAttribArray(attribute.number);
        glVertexAttribPointer(attribute.number, attribute.floats, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(vertex_bytes), offset_pointer(attribute.offset));
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return array;
}

void draw_triangles(GLuint vertex_array, std::size_t first_index, std::size_t index_count) {
    glBindVertexArray(vertex_array);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(index_count), GL_UNSIGNED_INT,
                   offset_pointer(first_index * sizeof(GLuint)));
}

void draw_fullscreen() {
    // The core profile draws nothing without a vertex array, even if no attribute is read.
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    const GlVertexArray empty(name);
    glBindVertexArray(empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace momentscope
