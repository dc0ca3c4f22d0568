// mesh_file.cpp -- Assimp's scene graph becomes one mesh; everything odd in it becomes a sentence.
#include "core/scene/mesh_file.hpp"

#include "core/error.hpp"
#include "core/scene/isolated_read.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

namespace momentscope {
namespace {

constexpr std::uint32_t UNUSED = std::numeric_limits<std::uint32_t>::max();
constexpr const char* NO_TRIANGLES = "has no triangles; export a surface, not points or lines.";
constexpr const char* NO_MEMORY = "needs more memory than there is; export it again or simplify the mesh.";
constexpr const char* FORMATS = "OBJ, PLY, STL, glTF or 3DS";

/// One mesh of the file at one place in the world.
struct Placed {
    const aiMesh* mesh;
    aiMatrix4x4 transform;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what_and_what_to_do) {
    throw Error("The mesh file '" + path.string() + "' " + what_and_what_to_do);
}

/// The file's size. Only ordinary files of bearable size go to Assimp, which reads them into memory whole.
std::uintmax_t check_file(const std::filesystem::path& path) {
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (status.type() == std::filesystem::file_type::not_found) fail(path, "does not exist; check the path.");
    if (std::filesystem::is_directory(status)) fail(path, "is a folder; name a file inside it.");
    if (!std::filesystem::is_regular_file(status))
        fail(path, "is not an ordinary file that can be read; copy the mesh to an ordinary file.");
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code || !std::ifstream(path, std::ios::binary))
        fail(path, "cannot be opened; make sure that you may read it.");
    if (size == 0) fail(path, std::string("is empty; export the mesh again, as ") + FORMATS + ".");
    if (size > MAX_MESH_FILE_BYTES)
        fail(path, "has more than " + std::to_string(MAX_MESH_FILE_BYTES >> 20) +
                       " MiB, the most that is read; simplify the mesh.");
    return size;
}

/// Assimp's message as part of a sentence: one line, not too long, without a full stop.
std::string tidy(std::string message) {
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    message.resize(std::min(message.size(), std::size_t{160}));
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    return message.empty() ? "no reason given" : message;
}

/// Lets Assimp read the file; `importer` owns the result.
const aiScene& import_file(Assimp::Importer& importer, const std::filesystem::path& path) {
    // Only shape counts here: what would keep equal vertices apart goes first, points and lines last.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                    aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                    aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // The data structure is validated first of all, before a step could follow a wild index.
    constexpr unsigned STEPS = aiProcess_ValidateDataStructure | aiProcess_RemoveComponent |
                               aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                               aiProcess_JoinIdenticalVertices | aiProcess_SortByPType;
    const aiScene* scene = importer.ReadFile(path.string(), STEPS);
    if (scene != nullptr && scene->mRootNode != nullptr) return *scene;

    const std::string message = importer.GetErrorString();
    if (message.starts_with("No suitable reader"))
        fail(path, std::string("is in no mesh format that Assimp knows; export it as ") + FORMATS + ".");
    if (message.find("std::bad_alloc") != std::string::npos) fail(path, NO_MEMORY);
    // In these words the validation and the step that drops points and lines say that nothing is left.
    for (const char* nothing : {"no faces", "no vertices", "mNumMeshes is 0", "No meshes remaining"}) {
        if (message.find(nothing) != std::string::npos) fail(path, NO_TRIANGLES);
    }
    fail(path, "cannot be read (" + tidy(message) + "); export it again, perhaps as " + FORMATS + ".");
}

/// All meshes in the order of the file's scene graph, instances repeated. Assimp could flatten the
/// graph itself (PreTransformVertices), but would reorder the meshes by material, and a small file
/// with many instances would fill the memory before anyone could count its triangles.
std::vector<Placed> place_meshes(const aiScene& scene, const std::filesystem::path& path) {
    struct Pending {
        const aiNode* node;
        aiMatrix4x4 parent;
    };
    std::vector<Placed> placed;
    std::vector<Pending> pending{{scene.mRootNode, aiMatrix4x4()}};  // a stack: graphs may be deep
    std::size_t triangle_count = 0;
    while (!pending.empty()) {
        const Pending current = pending.back();
        pending.pop_back();
        const aiMatrix4x4 transform = current.parent * current.node->mTransformation;
        for (unsigned i = 0; i < current.node->mNumMeshes; ++i) {
            const aiMesh* mesh = scene.mMeshes[current.node->mMeshes[i]];
            triangle_count += mesh->mNumFaces;
            if (triangle_count > MAX_MESH_TRIANGLES)
                fail(path, "has more than " + std::to_string(MAX_MESH_TRIANGLES) +
                               " triangles, the most that are read; simplify the mesh.");
            placed.push_back({mesh, transform});
        }
        for (unsigned i = current.node->mNumChildren; i-- > 0;)
            pending.push_back({current.node->mChildren[i], transform});
    }
    return placed;
}

glm::vec3 to_glm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// Appends the triangles of one placed mesh, and of its vertices those that a triangle uses.
void append(Mesh& out, const Placed& placed) {
    const aiMesh& mesh = *placed.mesh;
    const aiMatrix3x3 linear(placed.transform);
    // The transpose of the inverse up to a factor that is positive for rotations and mirrors alike.
    aiMatrix3x3 for_normals = linear;
    const bool mirrored = linear.Determinant() < 0.0f;
    for_normals.Inverse().Transpose();
    std::vector<std::uint32_t> renumbered(mesh.mNumVertices, UNUSED);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;
        for (unsigned corner = 0; corner < 3; ++corner) {
            // A mirror turns counter-clockwise into clockwise; swapping two corners turns it back.
            const unsigned vertex = face.mIndices[mirrored ? 2 - corner : corner];
            std::uint32_t& index = renumbered[vertex];
            if (index == UNUSED) {
                index = static_cast<std::uint32_t>(out.positions.size());
                out.positions.push_back(to_glm(placed.transform * mesh.mVertices[vertex]));
                out.normals.push_back(mesh.HasNormals() ? to_glm(for_normals * mesh.mNormals[vertex])
                                                        : glm::vec3(0.0f));
            }
            out.indices.push_back(index);
        }
    }
}

/// Centres the bounding box and scales its half diagonal to 1; in double, for 1e38 would overflow.
void normalize_placement(Mesh& mesh, const std::filesystem::path& path) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const glm::vec3& position : mesh.positions) {
        const glm::dvec3 p(position);
        if (!std::isfinite(p.x + p.y + p.z))
            fail(path, "has a vertex at infinity or at no number; repair the mesh and export it again.");
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double half_diagonal = 0.5 * glm::distance(low, high);
    if (!(half_diagonal > 0.0)) fail(path, "has all its triangles in one point; export it again.");
    for (glm::vec3& position : mesh.positions)
        position = glm::vec3((glm::dvec3(position) - 0.5 * (low + high)) / half_diagonal);
}

/// Makes every normal a unit vector. Files hold normals of length zero or no number, and Assimp makes
/// such where all triangles at a vertex have no area; those become the mean of what is around, or up.
void repair_normals(Mesh& mesh) {
    std::vector<glm::dvec3> around(mesh.normals.size(), glm::dvec3(0.0));
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[t + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[t + 2]]);
        const glm::dvec3 area = glm::cross(b - a, c - a);
        for (std::size_t corner = 0; corner < 3; ++corner) around[mesh.indices[t + corner]] += area;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        for (const glm::dvec3& candidate : {glm::dvec3(mesh.normals[i]), around[i], glm::dvec3(0, 1, 0)}) {
            const double length = glm::length(candidate);
            if (!(length > 1e-30) || !std::isfinite(length)) continue;
            mesh.normals[i] = glm::vec3(candidate / length);
            break;
        }
    }
}

/// Everything that a hostile file could derail.
Mesh read_with_assimp(const std::filesystem::path& path) {
    try {
        Assimp::Importer importer;  // logs nowhere as long as nobody creates Assimp's logger
        const aiScene& scene = import_file(importer, path);
        Mesh mesh;
        for (const Placed& placed : place_meshes(scene, path)) append(mesh, placed);
        if (mesh.indices.empty()) fail(path, NO_TRIANGLES);
        normalize_placement(mesh, path);
        repair_normals(mesh);
        return mesh;
    } catch (const std::bad_alloc&) {
        fail(path, NO_MEMORY);
    }
}

}  // namespace

// Assimp 5.2.5 falls over broken files: of files with a few flipped bytes, one in five ASE files ended
// in a segmentation fault, and a PLY file without "end_header" in a loop without end.
Mesh read_mesh_file(const std::filesystem::path& path, const std::stop_token& stop) {
    const std::uintmax_t size = check_file(path);
    // Assimp reads some 10 MB/s of text; ten times as long is allowed, and never less than 10 s.
    const auto seconds = static_cast<unsigned>(10 + size / 1'000'000);
    std::optional<Mesh> mesh = read_isolated([&] { return read_with_assimp(path); }, seconds, stop);
    if (!mesh)
        fail(path, std::string("is broken in a way that stops its reader; export it again, perhaps as ") +
                       FORMATS + ".");
    return *std::move(mesh);
}

}  // namespace momentscope
