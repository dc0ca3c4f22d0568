// obj_text_test.cpp -- OBJ files with all spellings, and text in all encodings.
#include "core/scene/obj_text.hpp"
#include "core/scene/text_encoding.hpp"
#include "tests/unit/mesh_folder.hpp"

#include <fmt/format.h>
#include <string_view>

using namespace momentscope;

namespace {

class ObjFile : public MeshFolder {};

/// Parallel panes of 2 by 1.6 at these depths, moved and then scaled; `format` is the format of numbers.
std::string panes_obj(const std::vector<double>& depths, glm::dvec3 moved, double scale, const char* format) {
    std::string text;
    for (const double z : depths) {
        for (const glm::dvec3 corner : {glm::dvec3(-1, -0.8, z), {1, -0.8, z}, {1, 0.8, z}, {-1, 0.8, z}}) {
            const glm::dvec3 p = scale * (corner + moved);
            text += 'v';
            for (const double number : {p.x, p.y, p.z})
                text += ' ' + fmt::format(fmt::runtime(format), number);
            text += '\n';
        }
        text += "f -4 -3 -2 -1\n";
    }
    return text;
}

const std::vector<double> FOUR_DEPTHS = {2.2634, 2.6967, 2.9133, 3.1299};  // for panes at 0, 0.25, 0.5 and 1

// The trials origin.obj, utm.obj and tiny.obj. Floats would merge their panes.
TEST_F(ObjFile, LosesNothingFarFromTheOriginOrAtAnyScale) {
    const auto expect_seen = [&](glm::dvec3 moved, double scale, const char* format) {
        SCOPED_TRACE(format);
        expect_depths(write("panes.obj", panes_obj({0, 0.25, 0.5, 1}, moved, scale, format)), FOUR_DEPTHS);
    };
    expect_seen({}, 1.0, "{:.3f}");
    expect_seen({448262.35, 5.0, 5411932.68}, 1.0, "{:.3f}");
    for (const double scale : {1e-300, 1e-45, 1e-20, 1e-5, 1e30, 1e250}) expect_seen({}, scale, "{:.9g}");
    expect_seen({}, 1e-20, "{:.25f}");  // Assimp drops digits after the 15th decimal place
    expect_warning(write("lost.obj", panes_obj({0, 0.25, 0.5, 1}, {0, 0, 1e14}, 1.0, "{:.3f}")),
                   "as large as 1e+14");
}

TEST_F(ObjFile, IgnoresVerticesThatNoFaceUses) {
    expect_depths(
        write("unused.obj", panes_obj({0, 0.25, 0.5, 1}, {}, 1.0, "{}") + "v 1e30 0 0\nv 0 -1e300 0\n"),
        FOUR_DEPTHS);
}

const char* const PLAIN = "v 0.5 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n";

TEST(ObjText, IsTheSameForEverySpellingThatTheFormatAllows) {
    for (
        const char* spelling : {
            "v .5 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n",
            "v +.5 -0. .0\nv 1. +1 0e5\nv 0 10E-1 0.1e+1\nf +1 2 3\n",
            "v .5e0 0 00\nv 001 1.000000000000000000000 1e-400\nv 0 1000000000000000000000000e-24 1\nf 1 2 3",
            "v .5 0 0\r\nv\t1  1 0 \r\nv 0 1 1 # a comment\r\nf 1 2 3#4\r\n",
            "v .5 0 0\rv 1 1 0\rv 0 1 1\rf 1 2 3\r",
            "  v .5 0 0\n\tv 1 \\\n1 \\\r\n0\nv 0 1 1\n f 1 2\\\n 3\n",
            "v .5 0 0 1\nv 1 1 0 .5\nv 0 1 1 0\nf 1 2 3\n",
            "v .5 0 0 1 .5 0\nv 1 1 0 1 1 nan\nv 0 1 1 0 0 0\nf 1 2 3\n",
            "v .5 0 0 1 .5 0 1\nv 1 1 0 1 1 1 1\nv 0 1 1 0 0 0 1\nf 1 2 3\n",
            "v .5 0 0\nv 1 1 0\nv 0 1 1\nf -3/ -2// -1\nvp 1 1\ns off\ncall x\n\\",
            "f 1 2 3\nv .5 0 0\nv 1 1 0\nv 0 1 1\n",
        })
        EXPECT_EQ(readable_obj(spelling, "x").text, readable_obj(PLAIN, "x").text) << spelling;
}

TEST_F(ObjFile, NormalsNamesAndTextureCoordinatesMayBeSpeltFreelyToo) {
    const Mesh plain = read_mesh_file(write("plain.obj", PLAIN)).mesh;
    for (const char* spelling : {
             "v .5 0 0\nv 1 1 0\nv 0 1 1\nvt .5\nvt .5 nan\nf 1/1 2/2/ 3/-1\n",
             "v .5 0 0\nv 1 1 0\nv 0 1 1\nvn nan nan nan\nvn 1 -.5 10e-1\nf -3//-1 2//2 -1//-1\n",
             "mtllib none at all.mtl\no a b\nv .5 0 0\nv 1 1 0\ng c\nv 0 1 1\nusemtl d #e\nf 1 2 3\n",
         }) {
        SCOPED_TRACE(spelling);
        const LoadedMesh loaded = read_mesh_file(write("spelt.obj", spelling));
        EXPECT_EQ(loaded.mesh.positions, plain.positions);
        EXPECT_EQ(loaded.mesh.indices, plain.indices);
        EXPECT_LT(glm::distance(loaded.mesh.normals[0], plain.normals[0]), 1e-6f);
        EXPECT_TRUE(loaded.warnings.empty());
    }
}

TEST(ObjText, RefusesWhatIsNoNumberWithTheLine) {
    const auto expect_refused = [](const std::string& text, const std::string& part) {
        expect_error([&] { readable_obj(text, "x.obj"); }, "The mesh file 'x.obj' cannot be read: " + part);
    };
    for (const char* word :
         {"1,5", "0x10", "nan", "-inf", "1e", "1e400", "+.5e400", "--1", "+-1", "1.2.3", "one", "1d3", "."})
        expect_refused(std::string("# first\n\nv 1 \\\n") + word + " 1\nf 1 1 1\n",
                       std::string("line 3 has '") + word + "'");
    expect_refused("v 1 2\n", "line 1 has a vertex of 2 numbers");
    expect_refused("v 1 2 3 4 5\n", "line 1 has a vertex of 5 numbers");
    const std::string vertices = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\n";
    expect_refused(vertices + "f 0 1 2\n", "line 4 has '0'");
    expect_refused(vertices + "f 1 2 3.0\n", "line 4 has '3.0'");
    expect_refused(vertices + "f 1 2 -4\n", "line 4 has a face with vertex '-4' of 3");
    expect_refused(vertices + "f 1 2 3\nf 1 2 4\n", "line 5 has a face with vertex 4 of 3");
    expect_refused(vertices + "f 1 2 99999999999999999999\n", "line 4 has '99999");
}

TEST_F(ObjFile, IsKnownByItsContentToo) {
    expect_depths(write("panes.txt", panes_obj({0, 0.25, 0.5, 1}, {}, 1e-20, "{}")), FOUR_DEPTHS);
}

TEST_F(ObjFile, WarnsOfWhatIsNotShown) {
    const std::string panes = panes_obj({0, 1}, {}, 1.0, "{}");
    for (const char* also : {"l 1 2\n", "p 1\n", "f 1 2\n", "curv 0 1 1 2\n"})
        expect_warning(write("lines.obj", panes + also), "points, lines or curves");
}

TEST_F(ObjFile, OpensNoMaterialsOutsideItsFolder) {
    const std::string panes = panes_obj({0, 1}, {}, 1.0, "{}");
    write("outside.mtl", "newmtl a\n");
    write("in/side/a b.mtl", "newmtl a\n");
    EXPECT_TRUE(read_mesh_file(write("in/a.obj", "mtllib side/a b.mtl\n" + panes)).warnings.empty());
    EXPECT_TRUE(read_mesh_file(write("in/b.obj", "mtllib ../none.mtl\n" + panes)).warnings.empty());
    expect_warning(write("in/c.obj", "mtllib ../outside.mtl\n" + panes),
                   "'../outside.mtl', which lies outside");
    expect_warning(write("in/d.obj", "mtllib /etc/passwd\n" + panes), "'/etc/passwd', which lies outside");
}

std::string encoded(std::string_view text, std::size_t unit, bool big_endian) {
    std::string bytes;
    for (const char c : text)
        for (std::size_t b = 0; b < unit; ++b) bytes += b == (big_endian ? unit - 1 : 0) ? c : '\0';
    return bytes;
}

TEST_F(ObjFile, TextMayBeInUtf16AndUtf32) {
    const std::string panes = panes_obj({0, 0.25, 0.5, 1}, {}, 1.0, "{}");
    const std::string triangles =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n-.5 0 0\n1 -1 0\n0 1 0\n3 0 1 2\n";
    const std::string facet =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex -.5 0 0\nvertex 1 -1 0\nvertex 0 1 0\nendloop\n"
        "endfacet\nendsolid a\n";
    const std::string off = "OFF\n3 1 0\n-.5 0 0\n1 -1 0\n0 1 0\n3 0 1 2\n";
    using namespace std::string_literals;
    for (const auto& [name, text] :
         {std::pair("a.obj", panes), {"a.ply", triangles}, {"a.stl", facet}, {"a.off", off}}) {
        SCOPED_TRACE(name);
        const Mesh plain = read_mesh_file(write(name, text)).mesh;
        for (const std::string& bytes : {"\xef\xbb\xbf" + text, "\xff\xfe" + encoded(text, 2, false)}) {
            const LoadedMesh loaded = read_mesh_file(write(name, bytes));
            EXPECT_EQ(loaded.mesh.positions, plain.positions);
            EXPECT_TRUE(loaded.warnings.empty());
        }
        for (const std::string& bytes :
             {"\xfe\xff" + encoded(text, 2, true), encoded(text, 2, false), encoded(text, 2, true),
              "\xff\xfe\0\0"s + encoded(text, 4, false), "\0\0\xfe\xff"s + encoded(text, 4, true)})
            EXPECT_EQ(as_utf8(bytes), text);
    }
}

TEST(TextEncoding, KeepsEveryCharacter) {
    using namespace std::string_view_literals;
    EXPECT_EQ(as_utf8("\xff\xfe"
                      "a\0\xfc\0\x64\x27\x3d\xd8\0\xde"sv),
              "a\u00fc\u2764\U0001F600");
    EXPECT_EQ(as_utf8("\xff\xfe\x3d\xd8"
                      "a\0b"sv),
              "\ufffd"
              "a");  // half a pair, half a character
    EXPECT_EQ(as_utf8("v 1 2 3\n"), std::nullopt);
    EXPECT_EQ(as_utf8("glTF\2\0\0\0\1\0\0\0\1\0\0\0JSON"sv), std::nullopt);
    EXPECT_EQ(as_utf8("a\0b\0c\0"sv), std::nullopt);  // too short to detect the encoding
    EXPECT_EQ(as_utf8(""), std::nullopt);
}

}  // namespace
