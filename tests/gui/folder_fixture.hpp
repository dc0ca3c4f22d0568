// folder_fixture.hpp -- opens the window in a temporary folder, where its dialogs start and its files are
// written.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {

namespace fs = std::filesystem;

class FolderTest : public GuiTest {
protected:
    FolderTest() {
        folder_ = fs::temp_directory_path() / fmt::format("momentscope-session-{}", ::getpid());
        fs::create_directories(folder_);
        before_ = fs::current_path();
        fs::current_path(folder_);  // dialogs start here
    }
    ~FolderTest() override {
        fs::current_path(before_);
        std::error_code status;
        fs::remove_all(folder_, status);
    }
    static void write(const fs::path& path, const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    static std::string read(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    fs::path folder_, before_;
};

}  // namespace momentscope::test
