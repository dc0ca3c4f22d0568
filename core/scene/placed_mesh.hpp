// placed_mesh.hpp -- meshes of a file put into its world in double, then around the origin in float.
#pragma once
#include "core/scene/loaded_mesh.hpp"

#include <assimp/mesh.h>
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace momentscope {

/// Triangles in the world of their file.
struct PlacedMesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  // unit vectors, or zero where the file has none
    std::vector<std::uint32_t> indices;
    double rounding = 0.0;      // how far positions may lie from where the file meant them, because of floats
    double coordinate = 0.0;    // the magnitude of the coordinate of which that comes
    std::size_t not_shown = 0;  // points and lines, which are left out
};

/// Where a mesh is put. Its vertices were divided by `unit` beforehand, a power of two.
struct Placement {
    glm::dmat4 transform = glm::dmat4(1.0);
    double unit = 1.0;
    double rounding = 0.0;    // of `transform`, as of PlacedMesh
    double coordinate = 0.0;  // of which that comes
};

/// One of each for each vertex of an aiMesh.
struct VertexArrays {
    const aiVector3D* positions = nullptr;
    const aiVector3D* normals = nullptr;  // none when null
};

/// Appends the triangles of the mesh, whose vertices are these, and of the vertices those that a triangle
/// uses. Vertices are joined when they are the same to the last bit.
void append_mesh(PlacedMesh& placed, const aiMesh& mesh, const VertexArrays& vertices,
                 const Placement& placement);

/// The bounding box's centre becomes the origin, its half diagonal 1; then the numbers are rounded to floats.
/// Normals become unit vectors, smooth ones where there are none. Warns when floats did not hold the
/// positions, and when there is next to nothing to see. Throws Error for positions that are not finite, all
/// the same, or farther apart than numbers go.
LoadedMesh centered_mesh(PlacedMesh placed, const std::filesystem::path& path);

/// Warns when positions may be wrong by more than a ten thousandth of the half diagonal.
void warn_of_rounding(std::vector<std::string>& warnings, const std::filesystem::path& path,
                      double coordinate, double rounding, double half_diagonal);

}  // namespace momentscope
