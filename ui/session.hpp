// session.hpp -- the state as JSON, in and out.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/ray/ray_json.hpp"
#include "ui/state.hpp"

namespace momentscope::ui {

constexpr int SESSION_VERSION = 1;
constexpr std::uintmax_t MAX_SESSION_BYTES = MAX_RAY_FILE_BYTES + (1U << 20);  // a ray is the only large part

/// Everything, so that the same window comes back bit by bit.
nlohmann::ordered_json session_to_json(const ExplorerState& state);

struct Session {
    ExplorerState state;
    std::vector<std::string> ignored;  // keys that this version does not know, the first of them
};

/// Missing keys stand for what a fresh window has. Throws Error for another version, a wrong type or a value
/// out of range, and names the key. `text` is bounded by the caller.
Session session_from_json(const std::string& text);

/// Throws Error also when the file is missing or too large. A mesh file is named relative to the session's
/// folder if it lies there, and else from the root, so that the session opens from every folder.
Session read_session_file(const std::filesystem::path& path);

/// Throws Error when a session cannot hold the name of the scene's file.
void require_session_name(const std::string& scene);

/// What is written. Throws Error as require_session_name does.
std::string session_text(const ExplorerState& state);
void write_session_file(const ExplorerState& state, const std::filesystem::path& path);

}  // namespace momentscope::ui
