// output_file_test.cpp -- a file is written completely or stays as it was, and protected files are not
// replaced.
#include "core/support/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/image/image.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

namespace fs = std::filesystem;

/// During its lifetime no file may grow, like on a full disk.
class FileLimit {
public:
    explicit FileLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit = {bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

class OutputFile : public testing::Test {
protected:
    OutputFile() : folder_(fs::temp_directory_path() / ("momentscope_output_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~OutputFile() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    static std::string content_of(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    long count() const { return std::distance(fs::directory_iterator(folder_), {}); }
    static fs::perms permissions_of(const fs::path& path) { return fs::status(path).permissions(); }

    fs::path folder_;
};

TEST_F(OutputFile, AFullDiskLeavesTheOldFileAndNoOther) {
    Image noise(64, 64);
    for (std::size_t i = 0; i < noise.pixels.size(); ++i)
        noise.pixels[i] = glm::vec4(static_cast<float>(i * 7919 % 257) / 257);
    for (const char* name : {"a.txt", "a.png", "a.exr"}) {
        const fs::path path = folder_ / name;
        write_file("old", path);
        const FileLimit limit(100);
        expect_error(
            [&] {
                if (path.extension() == ".txt")
                    write_file(std::string(1000, 'x'), path);
                else
                    write_image(noise, path);
            },
            "could not be written (File too large)");
        EXPECT_EQ(content_of(path), "old") << name;
    }
    EXPECT_EQ(count(), 3) << "and nothing half-written";
}

// Files with predictable names could be planted by somebody, or belong to somebody.
TEST_F(OutputFile, FilesBesideItAreNotTouched) {
    const fs::path neighbour = folder_ / ".a.partial.txt", precious = folder_ / "precious";
    write_file("precious", precious);
    fs::create_symlink(precious, neighbour);
    ASSERT_EQ(::mkfifo((folder_ / ".b.partial.txt").c_str(), 0600), 0);
    write_file("new", folder_ / "a.txt");
    write_file("new", folder_ / "b.txt");
    EXPECT_EQ(content_of(precious), "precious");
    EXPECT_TRUE(fs::is_symlink(neighbour));
    EXPECT_TRUE(fs::is_fifo(folder_ / ".b.partial.txt"));
    EXPECT_EQ(content_of(folder_ / "b.txt"), "new");
    EXPECT_EQ(count(), 5);
}

TEST_F(OutputFile, KeepsPermissions) {
    const fs::path path = folder_ / "a.txt";
    const mode_t mask = ::umask(022);
    write_file("first", path);
    EXPECT_EQ(permissions_of(path), fs::perms(0644));
    for (const int mode : {0600, 0664, 0755}) {
        fs::permissions(path, fs::perms(mode));
        write_file("again", path);
        EXPECT_EQ(permissions_of(path), fs::perms(mode));
    }
    ::umask(mask);
}

TEST_F(OutputFile, WritesWhatALinkPointsTo) {
    fs::create_directories(folder_ / "there");
    fs::create_symlink("there/real.txt", folder_ / "link.txt");  // relative, and the target is missing
    fs::create_symlink("link.txt", folder_ / "link-to-link.txt");
    for (const char* text : {"first", "second"}) {
        write_file(text, folder_ / "link-to-link.txt");
        EXPECT_EQ(content_of(folder_ / "there" / "real.txt"), text);
        EXPECT_FALSE(fs::is_symlink(folder_ / "there" / "real.txt"));
    }
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link-to-link.txt"));
    fs::create_symlink("round.txt", folder_ / "round.txt");
    expect_error([&] { write_file("x", folder_ / "round.txt"); }, "cannot be looked up");
}

TEST_F(OutputFile, FoldersPipesAndDevicesAreRefused) {
    expect_error([&] { write_file("x", folder_); }, "is a folder");
    expect_error([&] { write_file("x", folder_ / ""); }, "is a folder");
    expect_error([&] { write_file("x", folder_ / "none" / "a.txt"); }, "no folder");
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/null", folder_ / "device");
    for (const char* name : {"pipe", "device"})
        expect_error([&] { write_file("x", folder_ / name); }, "a device or a pipe");
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_TRUE(fs::is_character_file(folder_ / "device"));
    EXPECT_EQ(count(), 2);
}

}  // namespace
}  // namespace momentscope::test
