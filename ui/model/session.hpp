// session.hpp -- reads and writes the state as JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/ray/ray_json.hpp"
#include "ui/model/state.hpp"

namespace momentscope::ui {

constexpr int SESSION_VERSION = 1;
constexpr std::uintmax_t MAX_SESSION_BYTES = MAX_RAY_FILE_BYTES + (1U << 20);  // only a ray can be large

/// The whole state, so that the same window comes back bit by bit.
nlohmann::ordered_json session_to_json(const ExplorerState& state);

/// The value at a JSON pointer into the session of a state, such as "/parameters/beta"; nullopt if there is
/// none.
std::optional<nlohmann::json> session_value(const ExplorerState& state, const std::string& pointer);

struct Session {
    ExplorerState state;
    std::vector<std::string> ignored;  // the first keys that this version does not know
};

/// Missing keys keep the values of a fresh window. Throws Error for another version, a wrong type or a value
/// out of range, and names the key. The caller limits the size of `text`.
Session session_from_json(const std::string& text);

/// Throws Error also if the file is missing or too large. A relative name of a mesh file is first looked up
/// in the session's folder.
Session read_session_file(const std::filesystem::path& path);

/// The name of a scene in a file: a relative one of a mesh file is first looked up in the folder of the file.
std::string scene_beside(const std::string& scene, const std::filesystem::path& file);

/// Throws Error if a session cannot hold the name of the scene's file.
void require_session_name(const std::string& scene);

/// The text that write_session_file writes. Both throw Error like require_session_name. write_session_file
/// stores the name of a mesh file relative to the session's folder if the file lies there, and as an absolute
/// path otherwise, so the session opens from every folder.
std::string session_text(const ExplorerState& state);
void write_session_file(const ExplorerState& state, const std::filesystem::path& path);

}  // namespace momentscope::ui
