#include "core/scene/coarse_mesh.hpp"

#include <meshoptimizer.h>

#include <cstddef>
#include <utility>

namespace momentscope {

namespace {

constexpr std::size_t MIN_TRIANGLES = 2000;
constexpr std::size_t TRIANGLES_PER_KEPT = 4;
constexpr float MAX_MOVE = 0.01f;  // as a share of the extent of the mesh

template <typename Attribute>
std::vector<Attribute> used(const std::vector<Attribute>& attributes,
                            const std::vector<std::uint32_t>& new_places, std::size_t count) {
    if (attributes.empty()) return {};
    std::vector<Attribute> kept(count);
    meshopt_remapVertexBuffer(kept.data(), attributes.data(), attributes.size(), sizeof(Attribute),
                              new_places.data());
    return kept;
}

}  // namespace

Mesh coarse_mesh(Mesh mesh) {
    if (mesh.indices.size() < 3 * MIN_TRIANGLES) return mesh;
    std::vector<std::uint32_t> indices(mesh.indices.size());
    indices.resize(meshopt_simplify(indices.data(), mesh.indices.data(), mesh.indices.size(),
                                    &mesh.positions[0].x, mesh.positions.size(), sizeof(glm::vec3),
                                    mesh.indices.size() / TRIANGLES_PER_KEPT, MAX_MOVE));
    std::vector<std::uint32_t> new_places(mesh.positions.size());
    const std::size_t count = meshopt_optimizeVertexFetchRemap(new_places.data(), indices.data(),
                                                               indices.size(), mesh.positions.size());
    meshopt_remapIndexBuffer(indices.data(), indices.data(), indices.size(), new_places.data());
    return {.positions = used(mesh.positions, new_places, count),
            .normals = used(mesh.normals, new_places, count),
            .indices = std::move(indices),
            .texture_coordinates = used(mesh.texture_coordinates, new_places, count)};
}

}  // namespace momentscope
