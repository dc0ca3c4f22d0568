// host.hpp -- what the system around the window does with files and links, where the window does not do it
// itself.
#pragma once
#include <filesystem>
#include <functional>

namespace momentscope::ui {

struct ExplorerState;

/// A browser sets all functions. In a program of its own they are empty: the window then shows folders and
/// files itself, and there are no links.
struct Host {
    /// Lets the user choose a file whose name has this ending (""; any), and later calls Files::open_chosen.
    std::function<void(const char* extension)> choose_file{};

    /// Hands a file that was written to the user.
    std::function<void(const std::filesystem::path&)> deliver{};

    /// Copies the address of this state.
    std::function<void(const ExplorerState&)> copy_link{};

    bool shows_folders() const { return !choose_file; }
};

}  // namespace momentscope::ui
