// command_line_endless_test.cpp -- files that could be read or drawn endlessly are refused with a sentence.
#include "tests/unit/command_line_fixture.hpp"

#include <sys/stat.h>
#include <random>

namespace momentscope::test {
namespace {

class EndlessFiles : public CommandLine {};

TEST_F(EndlessFiles, OfPicturesAreRefused) {
    ASSERT_EQ(::mkfifo((folder_ / "fifo.png").c_str(), 0600), 0);
    write("area.pgm", "P5 16384 16384 255\n");
    write_picture(Image(2, 2), "a.png");
    for (const char* file : {"/dev/zero", "fifo.png"}) {
        expect_refused(fmt::format("compare {} a.png", file), "is not an ordinary file");
        expect_refused(fmt::format("compare a.png {}", file), "is not an ordinary file");
    }
    expect_refused("compare area.pgm a.png", "has 16384x16384 pixels");
}

// libpng prints its own messages; the program includes them in its sentence.
TEST_F(EndlessFiles, LibrariesHaveNoWordsOfTheirOwn) {
    Image picture(64, 64);
    std::mt19937 random(1);
    for (glm::vec4& pixel : picture.pixels)
        pixel =
            glm::vec4(static_cast<float>(random() % 256) / 255, 0.5f, static_cast<float>(random() % 2), 1);
    write_picture(picture, "whole.png");
    const std::string bytes = content_of(folder_ / "whole.png");
    write("half.png", bytes.substr(0, bytes.size() / 2));
    write("header.png", bytes.substr(0, 40));
    for (const char* file : {"half.png", "header.png"})
        expect_refused(fmt::format("compare {} whole.png", file), file);
}

// An axis of a chart that reaches to infinity would have infinitely many ticks.
TEST_F(EndlessFiles, OfChartsAreRefused) {
    const std::string settings =
        "# momentscope: chart\n# schema: 2\n# rows: 1\n# shard: 1/1\n"
        "scene,configuration,moments_ms,moments_range_ms,color_ms,color_range_ms,composite_ms,composite_range_ms,"
        "total_ms,total_range_ms,differential_ms,differential_range_ms,stored_bits,bits_with_factor,geometry_passes,"
        "rmse,delta_e,flip,stability,unavailable\n";
    for (const char* number : {"inf", "nan", "1e308"}) {
        write("a.csv",
              settings +
                  fmt::format("\"planes\",\"wboit\",1,0,1,0,1,0,{0},0,1,0,64,64,2,{0},1,1,1,\n", number));
        for (const char* kind : {"html", "svg", "png", "md"})
            expect_refused(fmt::format("merge a.csv -o out/a.{}", kind),
                           fmt::format("'a.csv' is damaged at '{}'", number));
    }
}

}  // namespace
}  // namespace momentscope::test
