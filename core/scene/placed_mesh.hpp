// placed_mesh.hpp -- places the meshes of a file in its world in double, and then around the origin in float.
#pragma once
#include "core/scene/loaded_mesh.hpp"

#include <assimp/mesh.h>
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace momentscope {

/// Triangles in the coordinates of their file.
struct PlacedMesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  // unit vectors, or zero if the file has none
    std::vector<std::uint32_t> indices;
    double rounding = 0.0;      // how far rounding to floats may have moved positions
    double coordinate = 0.0;    // magnitude of the coordinate that causes this rounding
    std::size_t not_shown = 0;  // points and lines, which are left out
};

/// The placement of a mesh. Its vertices were divided before by `unit`, a power of two.
struct Placement {
    glm::dmat4 transform = glm::dmat4(1.0);
    double unit = 1.0;
    double rounding = 0.0;    // of `transform`, as in PlacedMesh
    double coordinate = 0.0;  // that causes this rounding
};

/// One element of each array for each vertex of an aiMesh.
struct VertexArrays {
    const aiVector3D* positions = nullptr;
    const aiVector3D* normals = nullptr;  // null if there are none
};

/// Appends the triangles of the mesh with these vertices, and only vertices that a triangle uses. Vertices
/// that are equal to the last bit are joined.
void append_mesh(PlacedMesh& placed, const aiMesh& mesh, const VertexArrays& vertices,
                 const Placement& placement);

/// Moves the centre of the bounding box to the origin, scales its half diagonal to 1, and then rounds to
/// floats. Normals become unit vectors; missing ones are replaced by smooth ones. Warns if floats did not
/// hold the positions, and if there is almost nothing to see. Throws Error if positions are not finite, all
/// equal, or too far apart for numbers.
LoadedMesh centered_mesh(PlacedMesh placed, const std::filesystem::path& path);

/// Warns if positions may be wrong by more than a ten thousandth of the half diagonal.
void warn_of_rounding(std::vector<std::string>& warnings, const std::filesystem::path& path,
                      double coordinate, double rounding, double half_diagonal);

}  // namespace momentscope
