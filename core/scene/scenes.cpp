// scenes.cpp -- the registry of scenes, and scenes made from mesh files.
#include "core/scene/scenes.hpp"

#include "core/scene/builtin_scenes.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/support/error.hpp"
#include "core/support/reachable.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

namespace momentscope {
namespace {

constexpr SceneEntry ENTRIES[] = {
#define SCENE(id, description) {#id, description, build_##id},
#include "core/scene/builtin_scenes.def"
#undef SCENE
};

std::string scene_ids() {
    std::string ids;
    for (const SceneEntry& entry : ENTRIES) ids += (ids.empty() ? "" : ", ") + std::string(entry.id);
    return ids;
}

/// The mesh above an opaque ground, seen obliquely from above.
Scene scene_of_mesh(const std::string& path, float opacity, const std::stop_token& stop,
                    const ReadReport& report) {
    if (!(opacity >= 0.0f && opacity < 1.0f))  // also for NaN
        throw Error("The opacity of a mesh must be at least 0 and less than 1, such as 0.5.");
    Scene scene;
    scene.id = path;
    auto [mesh, warnings] = read_mesh_file(path, stop, report);
    scene.warnings = std::move(warnings);
    float lowest = std::numeric_limits<float>::infinity();
    for (const glm::vec3& position : mesh.positions) lowest = std::min(lowest, position.y);
    const std::uint32_t index = add_mesh(scene, std::move(mesh));
    scene.objects.push_back({index, glm::mat4(1.0f), linear_color(0x3E8ED0), opacity});
    add_ground(scene, 12.0f, lowest - 1e-3f);  // slightly lower, so as not to coincide with a flat base
    // The mesh fills a unit sphere. At a distance of 1 / sin(0.8 / 2) = 2.57, the sphere touches the edges of
    // the picture.
    scene.camera = {glm::vec3(0.0f), 2.7f, 0.5f, 0.3f, 0.8f};
    return scene;
}

}  // namespace

std::span<const SceneEntry> scene_entries() {
    return ENTRIES;
}

bool is_builtin_scene(const std::string& id) {
    return std::ranges::any_of(ENTRIES, [&](const SceneEntry& entry) { return id == entry.id; });
}

std::string absolute_scene(const std::string& id_or_path) {
    if (is_builtin_scene(id_or_path)) return id_or_path;
    std::error_code code;
    const std::filesystem::path path = std::filesystem::absolute(id_or_path, code);
    return code ? id_or_path : path.lexically_normal().string();
}

void require_scene(const std::string& id_or_path) {
    if (is_builtin_scene(id_or_path)) return;
    require_reachable(id_or_path);
    std::error_code code;
    if (!std::filesystem::exists(id_or_path, code))
        throw Error("There is no scene '" + id_or_path + "'; use one of " + scene_ids() +
                    ", or the path of a mesh file.");
}

Scene load_scene(const std::string& id_or_path, float opacity, const std::stop_token& stop,
                 const ReadReport& report) {
    for (const SceneEntry& entry : ENTRIES) {
        if (id_or_path == entry.id) return entry.build();
    }
    require_scene(id_or_path);
    return scene_of_mesh(id_or_path, opacity, stop, report);
}

}  // namespace momentscope
