// scenes.hpp -- the built-in scenes by id, and scenes made from mesh files.
#pragma once
#include "core/scene/read_report.hpp"
#include "core/scene/scene.hpp"

#include <span>
#include <stop_token>
#include <string>

namespace momentscope {

/// One row of the registry of scenes.
struct SceneEntry {
    const char* id;
    const char* description;  // one sentence: what it shows, and which figure it follows
    Scene (*build)();
};

/// All built-in scenes, in the order of listings.
std::span<const SceneEntry> scene_entries();

/// Throws Error if this is neither the id of a built-in scene nor an existing path.
void require_scene(const std::string& id_or_path);

/// The built-in scene with this id, or the mesh file at this path as one transparent object of the given
/// opacity in [0, 1). Throws Error if it is neither, if the file cannot be used, or if a stop is requested
/// during reading.
Scene load_scene(const std::string& id_or_path, float opacity, const std::stop_token& stop = {},
                 const ReadReport& report = {});

/// True if this is the id of a built-in scene. Otherwise it is the path of a mesh file, which may take long
/// to read.
bool is_builtin_scene(const std::string& id);

/// An id unchanged; a path as an absolute path, so that it names the same file from every folder.
std::string absolute_scene(const std::string& id_or_path);

}  // namespace momentscope
