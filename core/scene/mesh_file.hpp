// mesh_file.hpp -- reads any triangle mesh that Assimp knows.
#pragma once
#include "core/scene/loaded_mesh.hpp"
#include "core/scene/read_report.hpp"

#include <filesystem>
#include <stop_token>

namespace momentscope {

constexpr std::size_t MAX_MESH_FILE_BYTES = std::size_t{1} << 30;  // larger files are refused
constexpr std::size_t MAX_MESH_TRIANGLES = 20'000'000;

/// All triangles of a file in one mesh, in file order, scaled and moved so that its bounding box is
/// centred at the origin with a half diagonal of 1. Missing normals are made smooth. Warns of what the file
/// means otherwise than it is shown. Other files are opened only in the file's folder and below.
/// Throws Error for a folder, a file that is missing, too large, broken, without triangles or in need of what
/// is not read, for more memory than is free, and soon after a stop is requested.
LoadedMesh read_mesh_file(const std::filesystem::path& path, const std::stop_token& stop = {},
                          const ReadReport& report = {});

/// The same without a process of its own, so that a broken file may stop this one: for tests/fuzz.
LoadedMesh read_mesh_here(const std::filesystem::path& path, const ReadReport& report = {});

}  // namespace momentscope
