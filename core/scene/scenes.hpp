// scenes.hpp -- the built-in scenes by id, and scenes made of a mesh file.
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

/// All built-in scenes, in the order in which they are listed.
std::span<const SceneEntry> scene_entries();

/// Throws Error when it is neither the id of a built-in scene nor the path of anything.
void require_scene(const std::string& id_or_path);

/// The built-in scene of that id, or the mesh file at that path as one transparent object of
/// the given opacity in [0, 1). Throws Error when it is neither, the file cannot be used, or a stop is
/// requested while it is read.
Scene load_scene(const std::string& id_or_path, float opacity, const std::stop_token& stop = {},
                 const ReadReport& report = {});

/// Is it in the registry? What is not is the path of a mesh file, which may take long to read.
bool is_builtin_scene(const std::string& id);

/// An id as it is, and a path so that it names the same file from every folder.
std::string absolute_scene(const std::string& id_or_path);

}  // namespace momentscope
