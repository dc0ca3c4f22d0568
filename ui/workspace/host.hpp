// host.hpp -- what the system around the window does with files and links, where the window does not do it
// itself.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace momentscope::ui {

struct ExplorerState;

/// A browser sets all functions. A program of its own leaves those of files and links empty: the window then
/// shows folders and files itself, and there are no links. Without a display all are empty.
struct Host {
    /// Lets the user choose a file whose name has this ending (""; any), and later calls Files::open_chosen.
    std::function<void(const char* extension)> choose_file{};

    /// Hands a file that was written to the user.
    std::function<void(const std::filesystem::path&)> deliver{};

    /// Copies the address of this state.
    std::function<void(const ExplorerState&)> copy_link{};

    /// Keeps a text under a name for the next start, and gives it back ("": there is none). Both are set or
    /// neither is. They throw Error that says why not.
    std::function<void(const std::string& name, const std::string& text)> keep{};
    std::function<std::string(const std::string& name)> kept{};

    /// Fills the screen with the window, or stops to.
    std::function<void()> toggle_fullscreen{};

    bool shows_folders() const { return !choose_file; }
};

}  // namespace momentscope::ui
