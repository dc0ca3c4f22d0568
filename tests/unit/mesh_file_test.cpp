// mesh_file_test.cpp -- meshes from files: what is read, and which sentence refuses the rest.
#include "core/scene/mesh_file.hpp"
#include "core/scene/isolated_read.hpp"
#include "core/support/memory.hpp"
#include "tests/unit/mesh_checks.hpp"
#include "tests/unit/mesh_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

using namespace momentscope;

namespace {

namespace fs = std::filesystem;

class MeshFile : public MeshFolder {};

void expect_normalized(const Mesh& mesh) {
    const Extent extent = extent_of(mesh);
    EXPECT_NEAR(glm::length(extent.low + extent.high), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(extent.low, extent.high), 2.0f, 1e-5f);
}

const char* const TRIANGLE = "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n";

TEST_F(MeshFile, ATriangleIsCentredScaledAndGetsANormal) {
    const Mesh mesh = read_mesh_file(write("triangle.obj", TRIANGLE)).mesh;
    expect_well_formed(mesh);
    expect_normalized(mesh);
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_NEAR(mesh.positions[mesh.indices[0]].x, -0.8f, 1e-6f);  // the half diagonal was 2.5
    EXPECT_NEAR(mesh.positions[mesh.indices[0]].y, -0.6f, 1e-6f);
    EXPECT_NEAR(mesh.normals[0].z, 1.0f, 1e-6f);
}

TEST_F(MeshFile, QuadrilateralsAreSplitVerticesJoinedLinesDropped) {
    const std::string quads = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 9 9 9\nv 8 8 8\n";
    const Mesh mesh = read_mesh_file(write("quads.obj", quads + "f 1 2 3 4\nf 2 5 6 3\nl 7 8\n")).mesh;
    expect_well_formed(mesh);
    expect_normalized(mesh);  // the ends of the line would enlarge the box
    EXPECT_EQ(mesh.indices.size(), 12u);
    EXPECT_EQ(mesh.positions.size(), 6u);
}

TEST_F(MeshFile, HugeTinyAndDegenerateMeshesStayFinite) {
    for (const char* size : {"3e38", "1e-30"}) {
        const std::string s = size;
        const Mesh mesh =
            read_mesh_file(write("size.obj", "v -" + s + " 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nf 1 2 3\n"))
                .mesh;
        expect_well_formed(mesh);
        expect_normalized(mesh);
    }
    expect_well_formed(read_mesh_file(write("sliver.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")).mesh);
}

// Assimp joins vertices that are less than 1e-5 apart, whatever the scale.
TEST_F(MeshFile, PanesAtSmallScalesStayApart) {
    for (const double scale : {1.0, 1e-4, 1e-6, 1e-25}) {
        std::string text = "OFF\n12 3 0\n";
        for (const double z : {0.0, 0.5, 1.0})
            for (const glm::dvec3 p : {glm::dvec3(-1, -0.8, z), {1, -0.8, z}, {1, 0.8, z}, {-1, 0.8, z}})
                text += fmt::format("{:.9g} {:.9g} {:.9g}\n", scale * p.x, scale * p.y, scale * p.z);
        expect_depths(write("panes.off", text + "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n"),
                      {2.2634, 2.6967, 3.1299});
    }
}

TEST_F(MeshFile, WarnsOfCoordinatesThatFloatsCannotHold) {
    expect_warning(
        write("far.off", "OFF\n3 1 0\n448261 0 5411932.5\n448263 0 5411932.5\n448263 2 5411933\n3 0 1 2\n"),
        "as large as 5411933, where numbers lie 0.65 apart, but a half diagonal of only 1.436");
}

TEST_F(MeshFile, WarnsWhenNothingIsLeftToSee) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    expect_warning(write("far.obj", square + "v 1e30 0 0\nf 1 2 5\n"), "shows almost nothing");
    expect_warning(write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "shows almost nothing");
    std::string speck;
    for (int i = 0; i < 10; ++i)
        speck += fmt::format("v 0 0 {0}\nv 1 0 {0}\nv 1 1 {0}\nv 0 1 {0}\nf -4 -3 -2 -1\n", i);
    EXPECT_TRUE(read_mesh_file(write("panes.obj", speck)).warnings.empty());
    expect_warning(write("speck.obj", speck + "v 1e6 0 0\nv 0 1e6 0\nv 0 0 1e6\nf -1 -2 -3\n"),
                   "less than a pixel");
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
    expect_refused(write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "line 2 has 'nan'");
}

TEST_F(MeshFile, RefusesWhatIsTooLarge) {
    const fs::path path = write("large.obj", TRIANGLE);
    fs::resize_file(path, MAX_MESH_FILE_BYTES + 1);  // sparse, so it takes no space
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
        const Mesh mesh = read_mesh_file(models / name).mesh;
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
        const Mesh mesh = read_mesh_file(models / name).mesh;
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

TEST(IsolatedRead, BringsTheMeshTheWarningsAndTheErrorHome) {
    const std::vector<std::string> warnings = {"One.", "Two."};
    const auto read = [&](const ReadReport& report) {
        report("placing it");
        return LoadedMesh{ONE_TRIANGLE, warnings};
    };
    std::vector<std::string> reports;
    const std::optional<LoadedMesh> loaded =
        read_isolated(read, 5, {}, [&](const std::string& what) { reports.push_back(what); });
    EXPECT_EQ(reports, (std::vector<std::string>{"placing it", "taking 1 KiB of memory for 1 triangles"}));
    ASSERT_TRUE(loaded.has_value());
    EXPECT_EQ(loaded->mesh.positions, ONE_TRIANGLE.positions);
    EXPECT_EQ(loaded->mesh.normals, ONE_TRIANGLE.normals);
    EXPECT_EQ(loaded->mesh.indices, ONE_TRIANGLE.indices);
    EXPECT_EQ(loaded->warnings, warnings);
    try {
        read_isolated([](const ReadReport&) -> LoadedMesh { throw Error("A sentence."); }, 5);
        FAIL() << "the error did not arrive";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "A sentence.");
    }
}

TEST(IsolatedRead, OutlivesAReaderThatCrashesHangsOrLies) {
    EXPECT_FALSE(read_isolated([](const ReadReport&) -> LoadedMesh { std::abort(); }, 5));
    EXPECT_FALSE(read_isolated([](const ReadReport&) -> LoadedMesh { throw 1; }, 5));
    EXPECT_FALSE(read_isolated(
        [](const ReadReport&) -> LoadedMesh {
            for (;;) ::usleep(1000);
        },
        1));
    Mesh wild = ONE_TRIANGLE;
    wild.indices[2] = 3;
    EXPECT_FALSE(read_isolated([&](const ReadReport&) { return LoadedMesh{wild}; }, 5));
    Mesh incomplete = ONE_TRIANGLE;
    incomplete.indices.pop_back();
    EXPECT_FALSE(read_isolated([&](const ReadReport&) { return LoadedMesh{incomplete}; }, 5));
}

// A killed parent cannot tell its child; the system must.
TEST(IsolatedRead, EndsWithItsParent) {
    int held[2];
    ASSERT_EQ(::pipe2(held, O_CLOEXEC), 0);
    int begun[2];
    ASSERT_EQ(::pipe2(begun, O_CLOEXEC), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        read_isolated(
            [&](const ReadReport&) -> LoadedMesh {
                if (::write(begun[1], "x", 1) != 1) ::_exit(1);
                for (;;) ::pause();
            },
            60);
        ::_exit(0);
    }
    ::close(held[1]);
    char byte = 0;
    ASSERT_EQ(::read(begun[0], &byte, 1), 1);
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    // Both keep the other end of the pipe open during their lifetime.
    pollfd end{held[0], POLLIN, 0};
    constexpr int GENEROUS_MS = 20'000;
    EXPECT_EQ(::poll(&end, 1, GENEROUS_MS), 1) << "the reader lives on";
    for (const int file : {held[0], begun[0], begun[1]}) ::close(file);
}

TEST(IsolatedRead, IsStoppedWhileItReads) {
    std::stop_source stop;
    const auto begin = std::chrono::steady_clock::now();
    const auto read = [&](const ReadReport& report) -> LoadedMesh {
        report("reading");
        for (;;) ::pause();
    };
    expect_error(
        [&] { read_isolated(read, 60, stop.get_token(), [&](const std::string&) { stop.request_stop(); }); },
        "cancelled");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

// The memory for a file is reported before it is taken, and the content before it is drawn.
TEST_F(MeshFile, TellsItsMemoryAndItsTriangles) {
    std::vector<std::string> reports;
    read_mesh_file(write("triangle.obj", TRIANGLE), {},
                   [&](const std::string& what) { reports.push_back(what); });
    ASSERT_EQ(reports.size(), 3U);
    EXPECT_TRUE(reports[0].starts_with("reading 1 KiB, which takes about ")) << reports[0];
    EXPECT_EQ(reports[1], "placing its triangles");
    EXPECT_EQ(reports[2], "taking 1 KiB of memory for 1 triangles");
}

TEST(Memory, MoreThanIsFreeIsRefusedInNumbers) {
    EXPECT_NO_THROW(require_memory(1 << 20, "This", "leave it"));
    expect_error([] { require_memory(std::uintmax_t{1} << 60, "A mesh", "simplify it"); },
                 "A mesh takes 1073741824.0 GiB of memory, more than the ");
}

}  // namespace
