#include "app/last_words.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <optional>

#include "core/support/error.hpp"
#include "ui/model/session.hpp"

namespace momentscope {

namespace {

namespace fs = std::filesystem;

// The XDG base directory specification says that relative paths must be ignored.
std::optional<fs::path> folder_of_environment(const char* name) {
    const char* value = std::getenv(name);
    if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
    return fs::path(value);
}

// A name with the time in seconds, and with a number if that name exists.
fs::path new_file(const fs::path& folder) {
    const std::string stem = fmt::format("recovered-{:%Y-%m-%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
    fs::path path = folder / (stem + ".json");
    std::error_code status;
    for (int number = 2; fs::exists(path, status); ++number)
        path = folder / fmt::format("{}-{}.json", stem, number);
    return path;
}

}  // namespace

std::vector<fs::path> recovery_folders() {
    std::vector<fs::path> folders;
    if (const auto state = folder_of_environment("XDG_STATE_HOME")) folders.push_back(*state / "momentscope");
    if (const auto home = folder_of_environment("HOME"))
        folders.push_back(*home / ".local/state/momentscope");
    std::error_code status;
    const fs::path temporary = fs::temp_directory_path(status);
    if (!status) folders.push_back(temporary / "momentscope");
    return folders;
}

std::string last_words(const ui::ExplorerState& state) {
    std::string why = "there is no folder for it.";
    for (const fs::path& folder : recovery_folders()) try {
            std::error_code status;
            fs::create_directories(folder, status);  // if this fails, writing reports why
            const fs::path path = new_file(folder);
            ui::write_session_file(state, path);
            return fmt::format(
                "The display was lost, and the session was saved; open it with --session '{}'.",
                path.string());
        } catch (const std::exception& error) {
            why = error.what();
        }
    return fmt::format("The display was lost, and the session could not be saved: {}", why);
}

}  // namespace momentscope
