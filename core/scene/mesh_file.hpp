// mesh_file.hpp -- reads triangle meshes of any format that Assimp knows.
#pragma once
#include "core/scene/loaded_mesh.hpp"
#include "core/scene/read_report.hpp"

#include <filesystem>
#include <stop_token>

namespace momentscope {

constexpr std::size_t MAX_MESH_FILE_BYTES = std::size_t{1} << 30;  // larger files are refused
constexpr std::size_t MAX_MESH_TRIANGLES = 20'000'000;

/// All triangles of a file in one mesh, in file order, scaled and moved so that the bounding box is centred
/// at the origin with a half diagonal of 1. Missing normals are replaced by smooth ones. Warns about
/// everything that is shown differently from what the file means. Other files are opened only in the folder
/// of the file and below. Throws Error for a folder; for a file that is missing, too large, broken, without
/// triangles, or that requires something that is not read; if there is not enough memory; and soon after a
/// stop is requested.
LoadedMesh read_mesh_file(const std::filesystem::path& path, const std::stop_token& stop = {},
                          const ReadReport& report = {});

/// The same without a process of its own, so a broken file may crash this process. For tests/fuzz.
LoadedMesh read_mesh_here(const std::filesystem::path& path, const ReadReport& report = {});

}  // namespace momentscope
