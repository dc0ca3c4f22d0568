// mesh_graph.hpp -- walks the scene graph that Assimp has read.
#pragma once
#include "core/scene/gltf_file.hpp"
#include "core/scene/placed_mesh.hpp"

#include <assimp/scene.h>
#include <filesystem>
#include <vector>

namespace momentscope {

/// Divides the coordinates of each mesh by a power of two, without loss, so that the largest are about 1.
/// This is needed because Assimp multiplies lengths in floats when it splits polygons. Returns the factor
/// that undoes this, one for each mesh.
std::vector<double> scale_to_one(aiScene& scene);

struct PlacedGraph {
    PlacedMesh mesh;
    bool has_skin = false;          // has bones, which are not applied
    bool has_unused_morph = false;  // has morph targets with weights that are not applied
};

/// All meshes in the order of the scene graph of the file; instances are repeated. units: result of
/// scale_to_one. If `gltf` is given, transforms and weights of morph targets are taken from it. Throws Error
/// for more than MAX_MESH_TRIANGLES.
PlacedGraph place_graph(const aiScene& scene, const std::vector<double>& units, const GltfFile* gltf,
                        const std::filesystem::path& path);

}  // namespace momentscope
