// session_file.cpp -- session files, and how they refer to their mesh.
#include "ui/model/session.hpp"

#include <nlohmann/json.hpp>

#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/json_text.hpp"
#include "core/support/output_file.hpp"
#include "core/support/plain_text.hpp"

namespace momentscope::ui {

namespace {

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return std::filesystem::path(absolute_scene(file.string())).parent_path();
}

// The name relative to the session's folder if the mesh lies there, so that both can be moved together.
std::string portable_scene(const std::string& scene, const std::filesystem::path& session) {
    if (is_builtin_scene(scene)) return scene;
    const std::filesystem::path path = absolute_scene(scene);
    const std::filesystem::path relative = path.lexically_relative(folder_of(session));
    return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

}  // namespace

std::string scene_beside(const std::string& scene, const std::filesystem::path& file) {
    if (is_builtin_scene(scene)) return scene;
    const std::filesystem::path beside = folder_of(file) / scene;
    std::error_code code;
    return std::filesystem::exists(beside, code) ? beside.string() : scene;
}

Session read_session_file(const std::filesystem::path& path) {
    Session session = session_from_json(read_input_file(path, MAX_SESSION_BYTES, "session"));
    session.state.scene = scene_beside(session.state.scene, path);
    return session;
}

void require_session_name(const std::string& scene) {
    if (!is_utf8(scene))
        throw Error(
            "The name of the mesh file is not UTF-8, which a session needs; rename the file and open it again.");
}

std::string session_text(const ExplorerState& state) {
    require_session_name(state.scene);
    return json_text(session_to_json(state), 1) + "\n";
}

void write_session_file(const ExplorerState& state, const std::filesystem::path& path) {
    ExplorerState portable = state;
    portable.scene = portable_scene(state.scene, path);
    write_file(session_text(portable), path);
}

}  // namespace momentscope::ui
