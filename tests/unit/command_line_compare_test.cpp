// command_line_compare_test.cpp -- pictures that are compared.
#include "tests/unit/command_line_fixture.hpp"

#include <cmath>

using namespace momentscope;
using namespace momentscope::test;

namespace {

TEST_F(CommandLine, RefusesPicturesThatAreNone) {
    expect_refused("compare none.png none.png", "no picture 'none.png'");
    expect_refused("compare ray.json ray.json", "cannot be read (");
    write_picture(Image(4, 3), "a.exr");
    for (const char* region :
         {"1,2,3", "1,2,3,4,5", "1,2,3,x", "-1,0,2,2", "0,0,100000,1", "0,0,1.5,1", ",,,"})
        expect_refused(std::string("compare a.exr a.exr --region=") + region, "is not a region");
    expect_refused("compare a.exr a.exr --region 0,0,5,3", "does not lie within");
    expect_success("compare a.exr a.exr --region 1,0,3,3");
}

TEST_F(CommandLine, CompareTellsOfAlphaAndRefusesWhatIsNoNumber) {
    Image picture(4, 3);
    for (glm::vec4& pixel : picture.pixels) pixel = {0.25f, 0.5f, 0.75f, 1};
    write_picture(picture, "a.exr");
    EXPECT_EQ(expect_success("compare a.exr a.exr").output.find("alpha"), std::string::npos);
    picture.at(2, 1).a = 0.25f;
    write_picture(picture, "alpha.exr");
    EXPECT_NE(expect_success("compare a.exr alpha.exr").output.find("differ by at most 0.75"),
              std::string::npos);
    picture.at(1, 2).g = std::nanf("");
    picture.at(3, 2).b = INFINITY;
    write_picture(picture, "nan.exr");
    expect_refused("compare a.exr nan.exr",
                   "2 of the 12 pixels of 'nan.exr' are infinite or NaN, the first at 1,2");
    expect_refused("compare nan.exr nan.exr --metric rmse", "nan.exr");
}

}  // namespace
