#include "core/render/scene_buffers.hpp"

#include "core/render/uniform_blocks.hpp"

namespace momentscope {

namespace {

template <typename T>
GlBuffer make_buffer(const std::vector<T>& data) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    GlBuffer buffer(name);
    // GL refuses empty storage; a scene without objects still has a buffer.
    const auto bytes = static_cast<GLsizeiptr>(data.size() * sizeof(T));
    glNamedBufferStorage(buffer, bytes > 0 ? bytes : 4, bytes > 0 ? data.data() : nullptr, 0);
    return buffer;
}

struct Vertex {
    glm::vec3 position, normal;
};

}  // namespace

SceneBuffers::SceneBuffers(const Scene& scene) : objects_(scene.objects) {
    for (const Mesh& mesh : scene.meshes) meshes_.push_back(upload(mesh));
    std::vector<ObjectBlock> blocks;
    for (std::size_t i = 0; i < objects_.size(); ++i)
        blocks.push_back({objects_[i].model, glm::vec4(objects_[i].color, objects_[i].opacity),
                          glm::uvec4(static_cast<std::uint32_t>(i), 0, 0, 0)});
    object_blocks_ = make_buffer(blocks);
}

SceneBuffers::MeshBuffers SceneBuffers::upload(const Mesh& mesh) {
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({mesh.positions[i], mesh.normals[i]});
    MeshBuffers buffers;
    buffers.vertices = make_buffer(vertices);
    buffers.indices = make_buffer(mesh.indices);
    buffers.index_count = static_cast<GLsizei>(mesh.indices.size());
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    buffers.array = GlVertexArray(name);
    glVertexArrayVertexBuffer(name, 0, buffers.vertices, 0, sizeof(Vertex));
    glVertexArrayElementBuffer(name, buffers.indices);
    for (GLuint attribute : {0U, 1U}) {  // position, normal
        glEnableVertexArrayAttrib(name, attribute);
        glVertexArrayAttribFormat(name, attribute, 3, GL_FLOAT, GL_FALSE,
                                  attribute * static_cast<GLuint>(sizeof(glm::vec3)));
        glVertexArrayAttribBinding(name, attribute, 0);
    }
    return buffers;
}

void SceneBuffers::draw(Surfaces surfaces) const {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (objects_[i].opaque() != (surfaces == Surfaces::opaque)) continue;
        const MeshBuffers& mesh = meshes_[objects_[i].mesh];
        glBindBufferRange(GL_UNIFORM_BUFFER, 1, object_blocks_,
                          static_cast<GLintptr>(i * sizeof(ObjectBlock)), sizeof(ObjectBlock));
        glBindVertexArray(mesh.array);
        glDrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
    }
}

}  // namespace momentscope
