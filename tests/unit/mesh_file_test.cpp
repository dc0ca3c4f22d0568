// mesh_file_test.cpp -- meshes from files: what is read, and what is refused with which sentence.
#include "core/scene/mesh_file.hpp"
#include "core/error.hpp"
#include "core/scene/isolated_read.hpp"
#include "core/scene/scenes.hpp"
#include "tests/unit/mesh_checks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>

using namespace momentscope;

namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test's files, which goes with the test.
class MeshFile : public testing::Test {
protected:
    MeshFile() : folder_(fs::temp_directory_path() / ("momentscope_mesh_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~MeshFile() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    /// Expects one plain sentence that names the file and contains `part`.
    static void expect_refused(const fs::path& path, const std::string& part) {
        try {
            read_mesh_file(path);
            FAIL() << path << " was read";
        } catch (const Error& error) {
            const std::string sentence = error.what();
            EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
            EXPECT_NE(sentence.find(path.string()), std::string::npos) << sentence;
            EXPECT_EQ(sentence.back(), '.') << sentence;
            EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        }
    }

    fs::path folder_;
};

void expect_normalized(const Mesh& mesh) {
    const Extent extent = extent_of(mesh);
    EXPECT_NEAR(glm::length(extent.low + extent.high), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(extent.low, extent.high), 2.0f, 1e-5f);
}

const char* const TRIANGLE = "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n";

TEST_F(MeshFile, ATriangleIsCentredScaledAndGetsANormal) {
    const Mesh mesh = read_mesh_file(write("triangle.obj", TRIANGLE));
    expect_well_formed(mesh);
    expect_normalized(mesh);
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_NEAR(mesh.positions[mesh.indices[0]].x, -0.8f, 1e-6f);  // the half diagonal was 2.5
    EXPECT_NEAR(mesh.positions[mesh.indices[0]].y, -0.6f, 1e-6f);
    EXPECT_NEAR(mesh.normals[0].z, 1.0f, 1e-6f);
}

TEST_F(MeshFile, QuadrilateralsAreSplitVerticesJoinedLinesDropped) {
    const std::string quads = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 9 9 9\nv 8 8 8\n";
    const Mesh mesh = read_mesh_file(write("quads.obj", quads + "f 1 2 3 4\nf 2 5 6 3\nl 7 8\n"));
    expect_well_formed(mesh);
    expect_normalized(mesh);  // the line's ends would make the box larger
    EXPECT_EQ(mesh.indices.size(), 12u);
    EXPECT_EQ(mesh.positions.size(), 6u);
}

TEST_F(MeshFile, HugeTinyAndDegenerateMeshesStayFinite) {
    for (const char* size : {"3e38", "1e-30"}) {
        const std::string s = size;
        const Mesh mesh = read_mesh_file(
            write("size.obj", "v -" + s + " 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nf 1 2 3\n"));
        expect_well_formed(mesh);
        expect_normalized(mesh);
    }
    expect_well_formed(read_mesh_file(write("sliver.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")));
}

TEST_F(MeshFile, RefusesWhatIsNoMeshFile) {
    expect_refused(folder_ / "none.obj", "does not exist");
    expect_refused(folder_, "is a folder");
    expect_refused("/dev/null", "is not an ordinary file");
    expect_refused(write("empty.obj", ""), "is empty");
    expect_refused(write("notes.txt", "Dear diary\n"), "no mesh format that Assimp knows");
    expect_refused(write("noise", std::string("\x01\xfe\0\x7f", 4)), "no mesh format that Assimp knows");
    expect_refused(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "has no triangles");
    expect_refused(write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "has no triangles");
    expect_refused(write("spot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "in one point");
    expect_refused(write("wild.obj", "v 0 0 0\nv 1 0 0\nf 1 2 999\n"), "cannot be read");
    expect_refused(write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "at infinity or at no number");
}

TEST_F(MeshFile, RefusesWhatIsTooLarge) {
    const fs::path path = write("large.obj", TRIANGLE);
    fs::resize_file(path, MAX_MESH_FILE_BYTES + 1);  // sparse: takes no room
    expect_refused(path, "1024 MiB");
}

TEST_F(MeshFile, SurvivesGarbageInEveryCommonFormat) {
    std::mt19937 random(1);
    for (const char* name :
         {"g.obj", "g.stl", "g.off", "g.3ds", "g.glb", "g.gltf", "g.fbx", "g.dae", "g.ply"}) {
        std::string bytes(500, ' ');
        for (char& byte : bytes) byte = static_cast<char>(random());
        EXPECT_THROW(read_mesh_file(write(name, bytes)), Error) << name;
    }
}

TEST_F(MeshFile, ReadsTheModelsOfGlmark2) {
    const fs::path models = "/usr/share/glmark2/models";
    if (!fs::exists(models / "bunny.obj")) GTEST_SKIP() << "install glmark2-data";
    const std::pair<const char*, std::size_t> expected[] = {
        {"bunny.obj", 69666}, {"horse.3ds", 7172}, {"cat.3ds", 14348}, {"cube.3ds", 12}};
    for (const auto& [name, triangles] : expected) {
        SCOPED_TRACE(name);
        const Mesh mesh = read_mesh_file(models / name);
        expect_well_formed(mesh);
        expect_normalized(mesh);
        EXPECT_EQ(mesh.indices.size() / 3, triangles);
        EXPECT_GT(agreeing_triangles(mesh), 0.95);
    }
}

TEST_F(MeshFile, ReadsTheTestModelsOfAssimp) {
    const fs::path models = "/usr/share/assimp/models";
    if (!fs::exists(models / "PLY/Wuson.ply")) GTEST_SKIP() << "install assimp-testmodels";
    for (const char* name :
         {"PLY/Wuson.ply", "PLY/cube_binary.ply", "OBJ/spider.obj", "3DS/test1.3ds", "STL/Spider_binary.stl",
          "OFF/Wuson.off", "glTF2/BoxTextured-glTF/BoxTextured.gltf",
          "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"}) {
        SCOPED_TRACE(name);
        const Mesh mesh = read_mesh_file(models / name);
        expect_well_formed(mesh);
        expect_normalized(mesh);
    }
    for (const char* name : {"invalid/OutOfMemory.off", "invalid/malformed.obj", "PLY/points.ply",
                             "glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb"})
        EXPECT_THROW(read_mesh_file(models / name), Error) << name;
}

TEST_F(MeshFile, BecomesASceneAboveTheGround) {
    const std::string path = write("triangle.obj", TRIANGLE).string();
    const Scene scene = load_scene(path, 0.25f);
    EXPECT_EQ(scene.id, path);
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].opacity, 0.25f);
    EXPECT_TRUE(scene.objects[1].opaque());
    EXPECT_LT(scene.objects[1].model[3].y, extent_of(scene.meshes[0]).low.y);
    EXPECT_LE(transparent_bounds(scene).radius, 1.001f);

    EXPECT_NO_THROW(load_scene(path, 0.0f));
    for (const float opacity : {1.0f, -0.1f, 2.0f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_THROW(load_scene(path, opacity), Error);
    EXPECT_THROW(load_scene(folder_.string(), 0.5f), Error);
}

const Mesh ONE_TRIANGLE{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {0, 1, 2}};

TEST(IsolatedRead, BringsTheMeshAndTheErrorHome) {
    const std::optional<Mesh> mesh = read_isolated([] { return ONE_TRIANGLE; }, 5);
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(mesh->positions, ONE_TRIANGLE.positions);
    EXPECT_EQ(mesh->normals, ONE_TRIANGLE.normals);
    EXPECT_EQ(mesh->indices, ONE_TRIANGLE.indices);
    try {
        read_isolated([]() -> Mesh { throw Error("A sentence."); }, 5);
        FAIL() << "the error did not arrive";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "A sentence.");
    }
}

TEST(IsolatedRead, OutlivesAReaderThatCrashesHangsOrLies) {
    EXPECT_FALSE(read_isolated([]() -> Mesh { std::abort(); }, 5));
    EXPECT_FALSE(read_isolated([]() -> Mesh { throw 1; }, 5));
    EXPECT_FALSE(read_isolated(
        []() -> Mesh {
            for (;;) ::usleep(1000);
        },
        1));
    Mesh wild = ONE_TRIANGLE;
    wild.indices[2] = 3;
    EXPECT_FALSE(read_isolated([&] { return wild; }, 5));
    Mesh incomplete = ONE_TRIANGLE;
    incomplete.indices.pop_back();
    EXPECT_FALSE(read_isolated([&] { return incomplete; }, 5));
}

}  // namespace
