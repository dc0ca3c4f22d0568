#include "core/render/scene_buffers.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/gl/texture.hpp"
#include "core/ray/view_ray.hpp"
#include "core/render/scene_size.hpp"

namespace momentscope {

namespace {

template <typename T>
GlBuffer make_buffer(const std::vector<T>& data, GLbitfield flags = 0) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    GlBuffer buffer(name);
    // GL does not accept empty storage, and a scene without objects has a buffer, too.
    const auto bytes = static_cast<GLsizeiptr>(data.size() * sizeof(T));
    glNamedBufferStorage(buffer, bytes > 0 ? bytes : 4, bytes > 0 ? data.data() : nullptr, flags);
    return buffer;
}

// The unit in transparent_fragment.glsl. Techniques use the units from 0 on.
constexpr GLuint ALPHA_MAP_UNIT = 15;

GlTexture make_alpha_map(const AlphaMap& map) {
    GlTexture texture = make_texture(GL_R8, {map.width, map.height});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture, 0, 0, 0, map.width, map.height, GL_RED, GL_UNSIGNED_BYTE, map.bytes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_REPEAT);
    return texture;
}

}  // namespace

SceneBuffers::SceneBuffers(const Scene& scene) : objects_(scene.objects), sequence_(scene.objects.size()) {
    require_drawable(size_of(scene));
    for (const Mesh& mesh : scene.meshes) meshes_.push_back(upload(mesh));
    std::iota(sequence_.begin(), sequence_.end(), 0U);
    object_blocks_ = make_buffer(object_blocks(), GL_DYNAMIC_STORAGE_BIT);
    for (const AlphaMap& map : scene.alpha_maps) alpha_maps_.push_back(make_alpha_map(map));
    no_alpha_map_ = make_alpha_map({1, 1, {255}});
    check_gl("uploading the scene");
}

std::vector<ObjectBlock> SceneBuffers::object_blocks() const {
    std::vector<ObjectBlock> blocks(objects_.size());
    for (std::uint32_t draw = 0; draw < sequence_.size(); ++draw) {
        const std::uint32_t i = sequence_[draw];
        blocks[i] = {objects_[i].model, glm::vec4(objects_[i].color, objects_[i].opacity),
                     glm::uvec4(draw, i, 0, 0), glm::vec4(fragment_absorbance(objects_[i].opacity))};
    }
    return blocks;
}

void SceneBuffers::set_order(const SubmissionOrder& order) {
    if (order == order_) return;
    order_ = order;
    RandomNumbers random(order.seed);
    sequence_ = ordered_numbers(objects_.size(), order.kind, random);
    const std::vector<ObjectBlock> blocks = object_blocks();
    if (!blocks.empty())
        glNamedBufferSubData(object_blocks_, 0, static_cast<GLsizeiptr>(blocks.size() * sizeof(ObjectBlock)),
                             blocks.data());
    for (MeshBuffers& mesh : meshes_) {
        std::vector<std::uint32_t> indices;
        indices.reserve(mesh.submitted.size());
        for (const std::uint32_t triangle : ordered_numbers(mesh.submitted.size() / 3, order.kind, random))
            indices.insert(indices.end(), &mesh.submitted[3 * triangle], &mesh.submitted[3 * triangle] + 3);
        if (!indices.empty())
            glNamedBufferSubData(mesh.indices, 0,
                                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                                 indices.data());
    }
}

SceneBuffers::MeshBuffers SceneBuffers::upload(const Mesh& mesh) {
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({mesh.positions[i], mesh.normals[i],
                            mesh.texture_coordinates.empty() ? glm::vec2(0) : mesh.texture_coordinates[i]});
    MeshBuffers buffers;
    buffers.vertices = make_buffer(vertices);
    buffers.indices = make_buffer(mesh.indices, GL_DYNAMIC_STORAGE_BIT);
    buffers.submitted = mesh.indices;
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    buffers.array = GlVertexArray(name);
    glVertexArrayVertexBuffer(name, 0, buffers.vertices, 0, sizeof(Vertex));
    glVertexArrayElementBuffer(name, buffers.indices);
    const auto add_attribute = [&](GLuint attribute, GLint floats, std::size_t offset) {
        glEnableVertexArrayAttrib(name, attribute);
        glVertexArrayAttribFormat(name, attribute, floats, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(name, attribute, 0);
    };
    add_attribute(0, 3, offsetof(Vertex, position));
    add_attribute(1, 3, offsetof(Vertex, normal));
    add_attribute(2, 2, offsetof(Vertex, texture_coordinate));
    return buffers;
}

void SceneBuffers::draw(Surfaces surfaces) const {
    for (const std::size_t i : sequence_) {
        if (objects_[i].opaque() == (surfaces == Surfaces::transparent)) continue;
        if (surfaces == Surfaces::opaque_casters && !objects_[i].casts_shadow) continue;
        const MeshBuffers& mesh = meshes_[objects_[i].mesh];
        glBindBufferRange(GL_UNIFORM_BUFFER, 1, object_blocks_,
                          static_cast<GLintptr>(i * sizeof(ObjectBlock)), sizeof(ObjectBlock));
        glBindTextureUnit(ALPHA_MAP_UNIT,
                          objects_[i].alpha_map ? alpha_maps_[*objects_[i].alpha_map] : no_alpha_map_);
        glBindVertexArray(mesh.array);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.submitted.size()), GL_UNSIGNED_INT, nullptr);
    }
}

}  // namespace momentscope
