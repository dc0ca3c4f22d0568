// image_test.cpp -- pictures in memory and in files.
#include "core/image/image.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "core/image/alpha_map.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

namespace fs = std::filesystem;

// IEC 61966-2-1: examples of the curve from the standard, in 8 bits.
TEST(Srgb, FollowsTheStandard) {
    EXPECT_EQ(srgb_from_linear(0), 0);
    EXPECT_NEAR(srgb_from_linear(1), 1, 1e-6);
    EXPECT_NEAR(255 * srgb_from_linear(0.2140411f), 127.5f, 0.01f);
    EXPECT_NEAR(255 * srgb_from_linear(0.0021246f), 7.0f, 0.01f) << "the linear part: 12.92 x";
    EXPECT_EQ(srgb_from_linear(-3), 0);
    EXPECT_NEAR(srgb_from_linear(40), 1, 1e-6);
}

// Equation 3 of Reinhard et al. and Narkowicz's fit of the ACES curve, computed independently.
TEST(ToneMap, FollowsItsCurves) {
    for (const float linear : {0.0f, 0.25f, 1.0f, 8.0f})
        EXPECT_EQ(tone_mapped(linear, ToneMap::none), linear);
    EXPECT_FLOAT_EQ(tone_mapped(0.25f, ToneMap::reinhard), 0.2f);
    EXPECT_FLOAT_EQ(tone_mapped(3.0f, ToneMap::reinhard), 0.75f);
    EXPECT_NEAR(tone_mapped(0.18f, ToneMap::filmic), 0.2669f, 1e-4f);
    EXPECT_NEAR(tone_mapped(1.0f, ToneMap::filmic), 0.8038f, 1e-4f);
    for (const ToneMap curve : {ToneMap::reinhard, ToneMap::filmic}) {
        EXPECT_EQ(tone_mapped(0.0f, curve), 0.0f);
        for (float x = 0.05f; x < 20; x += 0.05f)
            EXPECT_GT(tone_mapped(x, curve), tone_mapped(x - 0.05f, curve));
    }
}

TEST(ToneMap, ChangesPngAndNotExr) {
    const fs::path folder = fs::temp_directory_path() / "momentscope-tone-test";
    fs::create_directories(folder);
    Image image(1, 1);
    image.at(0, 0) = {1.0f, 0.25f, 3.0f, 1.0f};
    write_image(image, folder / "a.png", ToneMap::reinhard);
    write_image(image, folder / "a.exr", ToneMap::reinhard);
    const glm::vec4 shown = read_image(folder / "a.png").at(0, 0);
    EXPECT_NEAR(shown.r, 0.5f, 5e-3f);  // half a step of 8 bits
    EXPECT_NEAR(shown.g, 0.2f, 3e-3f);
    EXPECT_NEAR(shown.b, 0.75f, 5e-3f);
    EXPECT_EQ(read_image(folder / "a.exr").at(0, 0), image.at(0, 0));
    fs::remove_all(folder);
}

// Files of renderers contain depths besides colours, in any order. OpenImageIO wrote these two files of one
// pixel with 32-bit channels: B = 0.3, N = 9, A = 0.5, Z = 7, R = 0.1, G = 0.2; and Y = 0.3, Z = 9.
TEST(ReadImage, FindsChannelsByTheirNames) {
    const fs::path folder = MOMENTSCOPE_TEST_IMAGES;
    EXPECT_EQ(read_image(folder / "channels.exr").at(0, 0), glm::vec4(0.1f, 0.2f, 0.3f, 0.5f));
    EXPECT_EQ(read_image(folder / "grey.exr").at(0, 0), glm::vec4(0.3f, 0.3f, 0.3f, 1.0f)) << "Z is no alpha";
}

// Rows of a map count from below. A picture without an alpha channel is taken as it is.
TEST(AlphaMaps, AreTheAlphaChannelOrTheFirst) {
    const fs::path folder = fs::temp_directory_path() / "momentscope-alpha-test";
    fs::create_directories(folder);
    std::vector<unsigned char> rgba;
    for (const unsigned char alpha : std::initializer_list<unsigned char>{10, 20, 30, 40, 50, 60})
        rgba.insert(rgba.end(), {255, 100, 0, alpha});
    write_png(rgba, 2, 3, folder / "rgba.png");
    const AlphaMap map = read_alpha_map(folder / "rgba.png");
    EXPECT_EQ(map.width, 2);
    EXPECT_EQ(map.height, 3);
    EXPECT_EQ(map.bytes, (std::vector<std::uint8_t>{50, 60, 30, 40, 10, 20}));
    std::ofstream(folder / "grey.pgm", std::ios::binary) << "P5 3 1 255\n" << '\x0a' << '\x7f' << '\xff';
    EXPECT_EQ(read_alpha_map(folder / "grey.pgm").bytes, (std::vector<std::uint8_t>{10, 127, 255}));
    fs::resize_file(folder / "rgba.png", fs::file_size(folder / "rgba.png") / 2);
    for (const char* name : {"rgba.png", "missing.png", "."}) {
        try {
            read_alpha_map(folder / name);
            ADD_FAILURE() << name << " is no map";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find((folder / name).string()), std::string::npos);
        }
    }
    fs::remove_all(folder);
}

// Reading these files would never end or take all memory. The header of a picture is enough to refuse it.
TEST(PictureFiles, OnlyOrdinaryFilesOfBearableSizeAreRead) {
    const fs::path folder = fs::temp_directory_path() / "momentscope-endless-test";
    fs::create_directories(folder);
    ASSERT_EQ(::mkfifo((folder / "fifo.png").c_str(), 0600), 0);
    for (const fs::path& path : {fs::path("/dev/zero"), folder / "fifo.png", folder}) {
        expect_error([&] { read_image(path); },
                     "The picture '" + path.string() + "' is not an ordinary file");
        expect_error([&] { read_alpha_map(path); },
                     "The opacity texture '" + path.string() + "' is not an ordinary file");
    }
    std::ofstream(folder / "area.pgm", std::ios::binary) << "P5 16384 16384 255\n";
    expect_error([&] { read_image(folder / "area.pgm"); }, "has 16384x16384 pixels");
    expect_error([&] { read_alpha_map(folder / "area.pgm"); }, "has 16384x16384 pixels");
    std::ofstream(folder / "memory.pgm", std::ios::binary) << "P5 100000 100000 65535\n";
    EXPECT_THROW(read_image(folder / "memory.pgm"), Error);
    fs::remove_all(folder);
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

TEST(WriteImage, RefusesUnknownKinds) {
    EXPECT_THROW(write_image(Image(1, 1), fs::temp_directory_path() / "momentscope-a.gif"), Error);
}

}  // namespace
}  // namespace momentscope::test
