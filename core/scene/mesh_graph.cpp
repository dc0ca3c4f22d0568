// mesh_graph.cpp -- walks the scene graph. Assimp could flatten the graph itself (PreTransformVertices), but
// it would do so in floats and reorder the meshes by material. A small file with many instances would also
// fill the memory before its triangles could be counted.
#include "core/scene/mesh_graph.hpp"

#include "core/scene/mesh_error.hpp"
#include "core/scene/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace momentscope {
namespace {

/// A node of the graph and, for a glTF file, the index of the same node in the file.
struct PendingNode {
    const aiNode* node;
    Placement parent;
    std::optional<std::uint32_t> gltf;
};

struct PlacedNode {
    const aiMesh* mesh;
    Placement placement;
    const std::vector<double>* morph_weights;  // null if the format stores them in the meshes
};

glm::dmat4 local_of(const aiNode& node) {
    const aiMatrix4x4& m = node.mTransformation;  // stored in rows
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

/// The placement of a node from that of its parent. A translation in floats was rounded by Assimp.
Placement placed_below(const Placement& parent, const glm::dmat4& local, bool is_float) {
    Placement placement = parent;
    placement.transform = parent.transform * local;
    if (!is_float) return placement;
    const glm::dvec3 shift = glm::abs(glm::dvec3(local[3]));
    for (int row = 0; row < 3; ++row) {
        double error = 0.0;
        for (int column = 0; column < 3; ++column)
            error += std::abs(parent.transform[column][row]) * shift[column] * 0x1p-24;
        placement.rounding = std::max(placement.rounding, parent.rounding + error);
    }
    placement.coordinate = std::max({parent.coordinate, shift.x, shift.y, shift.z});
    return placement;
}

/// The glTF nodes of the children of a node of the graph. nullopt for all if they do not correspond, which
/// happens in no known version of Assimp.
std::vector<std::optional<std::uint32_t>> gltf_children(const PendingNode& pending, const GltfFile* gltf) {
    const std::size_t count = pending.node->mNumChildren;
    std::vector<std::optional<std::uint32_t>> children(count);
    if (!pending.gltf) return children;
    const std::vector<std::uint32_t>& own = gltf->nodes[*pending.gltf].children;
    if (own.size() == count) std::ranges::copy(own, children.begin());
    return children;
}

/// The root of the graph; or its children, if Assimp added a root above several roots of the file.
std::vector<PendingNode> first_nodes(const aiScene& scene, const GltfFile* gltf) {
    const aiNode* root = scene.mRootNode;
    if (gltf == nullptr) return {{root, {}, std::nullopt}};
    if (gltf->roots.size() == 1) return {{root, {}, gltf->roots.front()}};
    std::vector<PendingNode> nodes;  // a stack, so the last comes first
    for (std::size_t i = root->mNumChildren; i-- > 0;) {
        const bool corresponds = gltf->roots.size() == root->mNumChildren;
        nodes.push_back({root->mChildren[i], {}, corresponds ? std::optional(gltf->roots[i]) : std::nullopt});
    }
    return nodes;
}

std::vector<PlacedNode> placed_nodes(const aiScene& scene, const std::vector<double>& units,
                                     const GltfFile* gltf, const std::filesystem::path& path) {
    std::vector<PlacedNode> placed;
    std::vector<PendingNode> pending = first_nodes(scene, gltf);  // a stack, because graphs may be deep
    std::size_t triangle_count = 0;
    while (!pending.empty()) {
        const PendingNode current = pending.back();
        pending.pop_back();
        const GltfNode* own = current.gltf ? &gltf->nodes[*current.gltf] : nullptr;
        const glm::dmat4 local = own != nullptr ? own->local : local_of(*current.node);
        Placement placement = placed_below(current.parent, local, own == nullptr);
        for (unsigned i = 0; i < current.node->mNumMeshes; ++i) {
            const unsigned index = current.node->mMeshes[i];
            const aiMesh* mesh = scene.mMeshes[index];
            triangle_count += mesh->mNumFaces;
            if (triangle_count > MAX_MESH_TRIANGLES)
                refuse_mesh(path, "has more than " + std::to_string(MAX_MESH_TRIANGLES) +
                                      " triangles, the most that are read; simplify the mesh.");
            Placement here = placement;
            here.unit = units[index];
            placed.push_back({mesh, here, own != nullptr ? &own->morph_weights : nullptr});
        }
        const auto children = gltf_children(current, gltf);
        for (unsigned i = current.node->mNumChildren; i-- > 0;)
            pending.push_back({current.node->mChildren[i], placement, children[i]});
    }
    return placed;
}

/// Moves each vector towards that of a morph target, which stores complete vectors and not differences.
void morph(std::vector<aiVector3D>& vectors, const aiVector3D* base, const aiVector3D* target,
           double weight) {
    const auto w = static_cast<float>(weight);
    for (std::size_t v = 0; v < vectors.size(); ++v) vectors[v] += (target[v] - base[v]) * w;
}

void append_node(PlacedGraph& graph, const PlacedNode& node) {
    const aiMesh& mesh = *node.mesh;
    VertexArrays vertices{mesh.mVertices, mesh.mNormals};
    std::vector<aiVector3D> positions, normals;
    graph.has_skin |= mesh.HasBones();
    const std::size_t count =
        node.morph_weights != nullptr ? node.morph_weights->size() : mesh.mNumAnimMeshes;
    for (std::size_t i = 0; i < count; ++i) {
        const aiAnimMesh* target = i < mesh.mNumAnimMeshes ? mesh.mAnimMeshes[i] : nullptr;
        const double weight =
            node.morph_weights != nullptr ? (*node.morph_weights)[i] : double{target->mWeight};
        if (weight == 0.0) continue;
        // Other formats define weights differently.
        if (node.morph_weights == nullptr || target == nullptr || target->mNumVertices != mesh.mNumVertices) {
            graph.has_unused_morph = true;
            continue;
        }
        if (positions.empty()) {
            positions.assign(mesh.mVertices, mesh.mVertices + mesh.mNumVertices);
            if (mesh.HasNormals()) normals.assign(mesh.mNormals, mesh.mNormals + mesh.mNumVertices);
            vertices = {positions.data(), mesh.HasNormals() ? normals.data() : nullptr};
        }
        if (target->HasPositions()) morph(positions, mesh.mVertices, target->mVertices, weight);
        if (target->HasNormals()) morph(normals, mesh.mNormals, target->mNormals, weight);
    }
    append_mesh(graph.mesh, mesh, vertices, node.placement);
}

}  // namespace

std::vector<double> scale_to_one(aiScene& scene) {
    std::vector<double> units;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        aiMesh& mesh = *scene.mMeshes[m];
        float largest = 0.0f;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            for (const float x : {mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z})
                if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        int exponent = 0;
        std::frexp(largest, &exponent);
        const auto scale = [&](aiVector3D* positions, unsigned count) {
            for (unsigned v = 0; positions != nullptr && v < count; ++v)
                for (float* x : {&positions[v].x, &positions[v].y, &positions[v].z})
                    *x = std::ldexp(*x, -exponent);
        };
        scale(mesh.mVertices, mesh.mNumVertices);
        for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i)
            scale(mesh.mAnimMeshes[i]->mVertices, mesh.mAnimMeshes[i]->mNumVertices);
        units.push_back(std::ldexp(1.0, exponent));
    }
    return units;
}

PlacedGraph place_graph(const aiScene& scene, const std::vector<double>& units, const GltfFile* gltf,
                        const std::filesystem::path& path) {
    PlacedGraph graph;
    for (const PlacedNode& node : placed_nodes(scene, units, gltf, path)) append_node(graph, node);
    return graph;
}

}  // namespace momentscope
