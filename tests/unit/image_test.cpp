// image_test.cpp -- pictures in memory and in files.
#include "core/image/image.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/output_file.hpp"

namespace momentscope::test {
namespace {

namespace fs = std::filesystem;

// IEC 61966-2-1: the standard's own examples of the curve, in 8 bits.
TEST(Srgb, FollowsTheStandard) {
    EXPECT_EQ(srgb_from_linear(0), 0);
    EXPECT_NEAR(srgb_from_linear(1), 1, 1e-6);
    EXPECT_NEAR(255 * srgb_from_linear(0.2140411f), 127.5f, 0.01f);
    EXPECT_NEAR(255 * srgb_from_linear(0.0021246f), 7.0f, 0.01f) << "the linear part: 12.92 x";
    EXPECT_EQ(srgb_from_linear(-3), 0);
    EXPECT_NEAR(srgb_from_linear(40), 1, 1e-6);
}

TEST(ImageValue, FlipsRows) {
    Image image(2, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 2; ++x) image.at(x, y) = glm::vec4(static_cast<float>(10 * y + x));
    Image flipped = image;
    flipped.flip_rows();
    EXPECT_EQ(flipped.at(1, 0), image.at(1, 2));
    EXPECT_EQ(flipped.at(0, 1), image.at(0, 1));
}

TEST(OutputFile, AFailureLeavesTheOldFileAndNoOther) {
    const fs::path folder = fs::temp_directory_path() / "momentscope-output-test";
    fs::create_directories(folder);
    const fs::path path = folder / "a.txt";
    write_text_file("old", path);
    EXPECT_THROW(replace_file(path,
                              [](const fs::path& partial) {
                                  std::ofstream(partial) << "half of it";
                                  return false;
                              }),
                 Error);
    std::ifstream file(path);
    std::string content;
    file >> content;
    EXPECT_EQ(content, "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
    EXPECT_THROW(write_text_file("x", folder), Error) << "a folder";
    EXPECT_THROW(write_text_file("x", folder / "none" / "a.txt"), Error) << "a missing folder";
    EXPECT_THROW(write_image(Image(1, 1), folder / "a.gif"), Error) << "an unknown kind";
    fs::remove_all(folder);
}

}  // namespace
}  // namespace momentscope::test
