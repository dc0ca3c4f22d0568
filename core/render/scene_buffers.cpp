#include "core/render/scene_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/gl/buffer.hpp"
#include "core/gl/gl_info.hpp"
#include "core/gl/texture.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/ray/view_ray.hpp"
#include "core/render/scene_size.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

// The unit in transparent_fragment.glsl. Techniques use the units from 0 on.
constexpr GLuint ALPHA_MAP_UNIT = 15;

constexpr GLuint OBJECT_BLOCK = 1;  // blocks.glsl

GlTexture make_alpha_map(const AlphaMap& map) {
    if (const int most = most_texels_of_a_side(); std::max(map.width, map.height) > most)
        throw Error(
            fmt::format("An opacity texture has {}x{} texels, but this GL takes at most {} on a side.",
                        map.width, map.height, most));
    GlTexture texture = make_texture(GL_R8, {map.width, map.height});
    write_texture(texture, {map.width, map.height}, GL_RED, GL_UNSIGNED_BYTE, map.bytes.data());
    interpolate_and_repeat(texture);
    return texture;
}

}  // namespace

SceneBuffers::SceneBuffers(const Scene& scene) : objects_(scene.objects), sequence_(scene.objects.size()) {
    require_drawable(size_of(scene));
    for (const Mesh& mesh : scene.meshes) meshes_.push_back(upload(mesh));
    std::iota(sequence_.begin(), sequence_.end(), 0U);
    object_blocks_ = make_buffer_of<ObjectBlock>(object_blocks());
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
    write_buffer(object_blocks_, 0, std::as_bytes(std::span(blocks)));
    for (MeshBuffers& mesh : meshes_) {
        std::vector<std::uint32_t> indices;
        indices.reserve(mesh.submitted.size());
        for (const std::uint32_t triangle : ordered_numbers(mesh.submitted.size() / 3, order.kind, random))
            indices.insert(indices.end(), &mesh.submitted[3 * triangle], &mesh.submitted[3 * triangle] + 3);
        write_buffer(mesh.indices, 0, std::as_bytes(std::span(indices)));
    }
}

SceneBuffers::MeshBuffers SceneBuffers::upload(const Mesh& mesh) {
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({mesh.positions[i], mesh.normals[i],
                            mesh.texture_coordinates.empty() ? glm::vec2(0) : mesh.texture_coordinates[i]});
    MeshBuffers buffers;
    buffers.vertices = make_buffer_of<Vertex>(vertices);
    buffers.indices = make_index_buffer(mesh.indices);
    buffers.submitted = mesh.indices;
    buffers.array = make_vertex_array(buffers.vertices, sizeof(Vertex),
                                      {{0, 3, offsetof(Vertex, position)},
                                       {1, 3, offsetof(Vertex, normal)},
                                       {2, 2, offsetof(Vertex, texture_coordinate)}},
                                      buffers.indices);
    return buffers;
}

bool SceneBuffers::belongs(std::size_t object, Surfaces surfaces) const {
    if (surfaces == Surfaces::transparent) return !objects_[object].opaque();
    return objects_[object].opaque() && (surfaces == Surfaces::opaque || objects_[object].casts_shadow);
}

std::size_t SceneBuffers::triangle_count(Surfaces surfaces) const {
    std::size_t count = 0;
    for (const std::size_t i : sequence_)
        if (belongs(i, surfaces)) count += meshes_[objects_[i].mesh].submitted.size() / 3;
    return count;
}

void SceneBuffers::draw(Surfaces surfaces, TriangleRange triangles) const {
    for (const std::size_t i : sequence_) {
        if (!belongs(i, surfaces)) continue;
        const MeshBuffers& mesh = meshes_[objects_[i].mesh];
        const std::size_t all = mesh.submitted.size() / 3;
        const std::size_t skipped = std::min(triangles.first, all);
        const std::size_t drawn = std::min(triangles.count, all - skipped);
        triangles.first -= skipped;
        triangles.count -= drawn;
        if (drawn == 0) continue;
        bind_uniforms(OBJECT_BLOCK, object_blocks_, i * sizeof(ObjectBlock), sizeof(ObjectBlock));
        bind_texture(ALPHA_MAP_UNIT,
                     objects_[i].alpha_map ? alpha_maps_[*objects_[i].alpha_map] : no_alpha_map_);
        draw_triangles(mesh.array, 3 * skipped, 3 * drawn);
    }
}

}  // namespace momentscope
