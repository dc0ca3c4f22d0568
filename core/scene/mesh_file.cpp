// mesh_file.cpp -- makes one mesh of what Assimp reads, and a sentence of everything odd in a file.
#include "core/scene/mesh_file.hpp"

#include "core/scene/folder_files.hpp"
#include "core/scene/gltf_file.hpp"
#include "core/scene/isolated_read.hpp"
#include "core/scene/mesh_error.hpp"
#include "core/scene/mesh_graph.hpp"
#include "core/scene/obj_text.hpp"
#include "core/scene/text_encoding.hpp"
#include "core/support/memory.hpp"
#include "core/support/plain_text.hpp"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

namespace momentscope {
namespace {

constexpr const char* NO_TRIANGLES = "has no triangles; export a surface, not points or lines.";
constexpr const char* NO_MEMORY = "needs more memory than there is; export it again or simplify the mesh.";
constexpr std::uintmax_t MEMORY_PER_BYTE = 12;  // for a reader, per byte of a file; PLY 9, STL 5, OBJ 11
constexpr const char* FORMATS = "OBJ, PLY, STL, glTF or 3DS";

/// The size of the file. Throws Error unless it is an ordinary file of a size that can be handled, because
/// Assimp reads files into memory as a whole.
std::uintmax_t check_file(const std::filesystem::path& path) {
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse_mesh(path, "does not exist; check the path.");
    if (std::filesystem::is_directory(status)) refuse_mesh(path, "is a folder; name a file inside it.");
    if (!std::filesystem::is_regular_file(status))
        refuse_mesh(path, "is not an ordinary file that can be read; copy the mesh to an ordinary file.");
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code || !std::ifstream(path, std::ios::binary))
        refuse_mesh(path, "cannot be opened; make sure that you may read it.");
    if (size == 0) refuse_mesh(path, std::string("is empty; export the mesh again, as ") + FORMATS + ".");
    if (size > MAX_MESH_FILE_BYTES)
        refuse_mesh(path, "has more than " + std::to_string(MAX_MESH_FILE_BYTES >> 20) +
                              " MiB, the most that is read; simplify the mesh.");
    return size;
}

/// The message of Assimp as part of a sentence: one line, not too long, without a full stop.
std::string tidy(std::string message) {
    message = one_line(message);
    message.resize(std::min(message.size(), std::size_t{160}));
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    return message.empty() ? "no reason given" : message;
}

/// The first `most` bytes of a file, or all of them if it is smaller.
std::string bytes_of(const std::filesystem::path& path, std::uintmax_t most = MAX_MESH_FILE_BYTES) {
    std::string bytes(static_cast<std::size_t>(std::min(most, std::filesystem::file_size(path))), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

/// What is known about a file before Assimp reads it.
struct PreparedFile {
    std::optional<std::string> text;  // what Assimp reads instead of the file
    std::optional<GltfFile> gltf;
    std::vector<std::string> warnings = {};
    bool leaves_out_lines = false;
};

/// Converts text in other encodings to UTF-8, and OBJ to a form that Assimp reads without loss. Reads the
/// nodes of glTF.
PreparedFile prepare(const std::filesystem::path& path) {
    PreparedFile file;
    const std::string beginning = bytes_of(path, 256);
    if (as_utf8(beginning)) file.text = as_utf8(bytes_of(path));

    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool known = aiIsExtensionSupported(extension.c_str()) == AI_TRUE;
    const std::string start = file.text ? file.text->substr(0, beginning.size()) : beginning;
    const std::size_t first = std::min(start.find_first_not_of(" \t\r\n"), start.size());
    const bool maybe_gltf = start.starts_with("glTF") || start.substr(first).starts_with('{');
    if (extension != ".obj" && known && !maybe_gltf) return file;

    std::string source = file.text ? *file.text : bytes_of(path);
    if (extension == ".obj" || (!known && looks_like_obj(source))) {
        ObjText obj = readable_obj(source, path);
        file.leaves_out_lines = obj.not_shown > 0;
        warn_of_rounding(file.warnings, path, obj.coordinate, 0x1p-53 * obj.coordinate, obj.half_diagonal);
        file.text = std::move(obj.text);
    } else if (maybe_gltf) {
        file.gltf = read_gltf(source, path);
    }
    return file;
}

struct Release {
    void operator()(const aiScene* scene) const { aiReleaseImport(scene); }
};
using Imported = std::unique_ptr<const aiScene, Release>;

/// Throws std::bad_alloc if there is less memory than Assimp takes for triangles. If it runs out of memory
/// itself, it releases the scene twice and crashes.
void require_memory_to_triangulate(const aiScene& scene) {
    constexpr std::size_t BYTES = 64;  // an aiFace, its three indices and the bookkeeping of the heap
    std::size_t triangles = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
            triangles += std::max(scene.mMeshes[m]->mFaces[f].mNumIndices, 2u) - 2;
    ::operator delete(::operator new(BYTES* triangles));
}

/// Throws Error with the reason why Assimp could not read the file.
[[noreturn]] void refuse_unread(const std::string& message, const FolderFiles& files,
                                const std::filesystem::path& path) {
    if (files.outside())
        refuse_mesh(path,
                    "needs '" + *files.outside() +
                        "', which lies outside its folder and is not opened; put both into one folder.");
    if (message.starts_with("No suitable reader"))
        refuse_mesh(path,
                    std::string("is in no mesh format that Assimp knows; export it as ") + FORMATS + ".");
    if (message.find("std::bad_alloc") != std::string::npos) refuse_mesh(path, NO_MEMORY);
    // The validation uses these words if there is nothing in the file.
    for (const char* nothing : {"no faces", "no vertices", "mNumMeshes is 0", "No meshes remaining"}) {
        if (message.find(nothing) != std::string::npos) refuse_mesh(path, NO_TRIANGLES);
    }
    refuse_mesh(path, "cannot be read (" + tidy(message) + "); export it again, perhaps as " + FORMATS + ".");
}

/// Warnings about everything that is shown differently from what the file means.
std::vector<std::string> warnings_of(const PreparedFile& file, const FolderFiles& files,
                                     const PlacedGraph& graph, const std::filesystem::path& path) {
    std::vector<std::string> warnings = file.warnings;
    const auto warn = [&](const std::string& text) { warnings.push_back(mesh_sentence(path, text)); };
    if (file.gltf && !file.gltf->unread.empty()) warn("uses " + file.gltf->unread + "; it is shown without.");
    if (files.outside())
        warn("names '" + *files.outside() + "', which lies outside its folder and was not opened.");
    if (graph.has_skin)
        warn("has a skeleton, which is not read; its meshes are shown in the pose in which they were made.");
    if (graph.has_unused_morph) warn("has morph targets, which are not read; its meshes are shown without.");
    if (file.leaves_out_lines || graph.mesh.not_shown > 0)
        warn("has points, lines or curves, which are not shown; export them as surfaces.");
    return warnings;
}

}  // namespace

// Everything that a hostile file could crash. It calls Assimp through its C interface, because the classes of
// Assimp hold strings of one standard library and cannot be used with another.
LoadedMesh read_mesh_here(const std::filesystem::path& path, const ReadReport& report) {
    try {
        PreparedFile file = prepare(path);
        FolderFiles files(path, std::exchange(file.text, std::nullopt), file.gltf.has_value());
        aiFileIO opened = files.for_assimp();
        // The first step is validation, before another step could follow an index that is out of range.
        Imported scene(aiImportFileEx(path.c_str(), aiProcess_ValidateDataStructure, &opened));
        if (!scene) refuse_unread(aiGetErrorString(), files, path);
        // The scene may be changed here, just as the next step changes it.
        const std::vector<double> units = scale_to_one(const_cast<aiScene&>(*scene));
        require_memory_to_triangulate(*scene);
        scene.reset(aiApplyPostProcessing(scene.release(), aiProcess_Triangulate));
        if (!scene || scene->mRootNode == nullptr)
            refuse_unread("Assimp could not make triangles of it", files, path);

        if (report) report("placing its triangles");
        PlacedGraph graph = place_graph(*scene, units, file.gltf ? &*file.gltf : nullptr, path);
        if (graph.mesh.indices.empty()) refuse_mesh(path, NO_TRIANGLES);
        std::vector<std::string> warnings = warnings_of(file, files, graph, path);
        LoadedMesh loaded = centered_mesh(std::move(graph.mesh), path);
        warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
        loaded.warnings = std::move(warnings);
        return loaded;
    } catch (const std::bad_alloc&) {
        refuse_mesh(path, NO_MEMORY);
    }
}

// Assimp 5.2.5 fails on broken files. Of ASE files with a few flipped bytes, one in five ended in a
// segmentation fault, and a PLY file without "end_header" led to an endless loop.
LoadedMesh read_mesh_file(const std::filesystem::path& path, const std::stop_token& stop,
                          const ReadReport& report) {
    const std::uintmax_t size = check_file(path);
    if (report)
        report("reading " + memory_text(size) + ", which takes about " + memory_text(size * MEMORY_PER_BYTE) +
               " of memory");
    // Assimp reads about 10 MB/s of text. The limit is ten times the time for this, and at least 10 s.
    const auto seconds = static_cast<unsigned>(10 + size / 1'000'000);
    std::optional<LoadedMesh> mesh = read_isolated(
        [&](const ReadReport& stage) { return read_mesh_here(path, stage); }, seconds, stop, report);
    if (!mesh)
        refuse_mesh(path,
                    std::string("is broken in a way that stops its reader; export it again, perhaps as ") +
                        FORMATS + ".");
    return *std::move(mesh);
}

}  // namespace momentscope
