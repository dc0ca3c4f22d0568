// files_test.cpp -- files that the window opens, saves and exports.
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "core/ray/ray_json.hpp"
#include "tests/gui/folder_fixture.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session.hpp"

namespace momentscope::test {
namespace {

class FilesTest : public FolderTest {};

TEST_F(FilesTest, SavingAsksBeforeItReplaces) {
    open();
    write("momentscope.json", "precious");
    play("key Ctrl+S\nkey Enter");
    EXPECT_EQ(read("momentscope.json"), "precious");
    play("click @file.cancel");
    EXPECT_EQ(read("momentscope.json"), "precious");
    play("key Ctrl+S\nclick @file.accept\nclick @file.accept");
    EXPECT_NE(read("momentscope.json"), "precious");
}

// No file may grow, like on a full disk. The window stays open and shows a message.
TEST_F(FilesTest, AFullDiskKeepsTheOldSessionAndExports) {
    open("planes", "power4-32");
    write("momentscope.json", "precious");
    write("curves.csv", "precious");
    write("curves.png", "precious");
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit full = {100, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
    const char* said =
        "expect-message could not be written (File too large); check the folder and free space.\n";
    play(std::string("key Ctrl+S\nclick @file.accept\nclick @file.accept\n") + said);
    play(std::string("key Ctrl+E\nclick @file.accept\nclick @file.accept\n") + said);
    play(std::string("key Ctrl+E\nclick @file.kind\nclick @file.kind.window_png\nclick @file.accept\n"
                     "click @file.accept\nwait 1\n") +
         said);
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    for (const char* name : {"momentscope.json", "curves.csv", "curves.png"})
        EXPECT_EQ(read(name), "precious") << name;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 3) << "and nothing half-written";
    play("key Ctrl+S\nclick @file.accept\nclick @file.accept\nexpect-message The session was saved");
    EXPECT_NE(read("momentscope.json"), "precious");
}

TEST_F(FilesTest, EveryExportIsWritten) {
    open("planes", "power4-32");
    play("key Ctrl+2");
    const char* kinds[] = {"curves_csv",  "curves_json", "fragments_csv", "ray_json",
                           "picture_png", "picture_exr", "window_png"};
    int number = 0;
    for (const char* kind : kinds) {
        play(
            fmt::format("key Ctrl+E\nclick @file.kind\nclick @file.kind.{}\nclick @file.name\nkey "
                        "Ctrl+A\ntype out{}\nkey Enter\n"
                        "wait 1",
                        kind, number++));
        EXPECT_NE(message().find("Written to"), std::string::npos) << kind << ": " << message();
    }
    const auto curves = nlohmann::json::parse(read("out1.json"));
    EXPECT_EQ(curves["curves"][0]["reconstructed"].size(), measurement().curve.depth.size());
    EXPECT_EQ(ray_from_json(read("out3.json")).fragments.size(), measurement().capture.ray.fragments.size());
    const std::string fragments = read("out2.csv");
    EXPECT_EQ(std::ranges::count(fragments, '\n'), static_cast<long>(1 + measurement().history.size()));
    for (const char* picture : {"out4.png", "out5.exr", "out6.png"})
        EXPECT_GT(fs::file_size(picture), 1000u) << picture;
}

TEST_F(FilesTest, ARayFileIsPlotted) {
    write("ray.json", R"({"fragments": [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": 0.7}]})");
    open();
    play("key Ctrl+J\nclick @file.entry.ray.json\nclick @file.accept");
    ASSERT_TRUE(state().ray) << message();
    EXPECT_EQ(measurement().capture.ray.fragments.size(), 2u);
    play("key Ctrl+2\nclick @fragment.2\nkey P\nkey Home\nkey Left\nhold G\nlet G");
    EXPECT_EQ(state().marked, std::optional<std::size_t>(1));
    play("key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z");
    EXPECT_FALSE(state().ray) << "undone, the scene is back";
    EXPECT_EQ(measurement().capture.ray.fragments.size(), 4u);
}

TEST_F(FilesTest, ARayOfManyFragmentsIsDrawnWhole) {
    std::string fragments;
    for (int i = 0; i < 40'000; ++i)
        fragments +=
            fmt::format(R"({}{{"depth": {}, "opacity": 0.0001}})", i == 0 ? "" : ",", -1 + 2.0 * i / 40'000);
    write("many.json", fmt::format(R"({{"fragments": [{}]}})", fragments));
    open();
    play("key Ctrl+J\nclick @file.entry.many.json\nclick @file.accept\nmove -10 -10");
    ASSERT_TRUE(state().ray) << message();
    // Right of the middle, the truth is above half of its height, so its light colour must be found there.
    const ui::Rect plot = workspace().widget_rects.at("plot");
    const auto pixels = screen();
    const int x = static_cast<int>(plot.low.x + 0.75f * (plot.high.x - plot.low.x));
    int bright = 0;
    for (int y = static_cast<int>(plot.low.y); y < static_cast<int>(0.5f * (plot.low.y + plot.high.y)); ++y)
        bright += pixels[4u * static_cast<unsigned>(y * size_.x + x)] > 150 ? 1 : 0;
    EXPECT_GT(bright, 0);
}

TEST_F(FilesTest, AHugeMeshCanBeCancelled) {
    // 400,000 triangles as text take long enough that the first frames are still loading.
    std::string mesh;
    for (int i = 0; i < 200'000; ++i) mesh += fmt::format("v {} {} {}\n", i % 997, i % 991, i % 983);
    for (int i = 1; i < 199'998; ++i)
        mesh += fmt::format("f {} {} {}\nf {} {} {}\n", i, i + 1, i + 2, i, i + 2, i + 1);
    write("huge.obj", mesh);
    open();
    const ui::ExplorerState before = state();
    ui::choose_scene(workspace().state, (folder_ / "huge.obj").string());
    draw();
    ASSERT_TRUE(workspace().scene.is_reading());
    draw();
    const ui::Rect cancel = workspace().widget_rects.at("loading.cancel");
    ImGui::GetIO().MousePos = {0.5f * (cancel.low.x + cancel.high.x), 0.5f * (cancel.low.y + cancel.high.y)};
    for (const bool down : {false, true, false}) {
        ImGui::GetIO().MouseDown[0] = down;
        draw();
    }
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_NE(message().find("cancelled"), std::string::npos) << message();
}

TEST_F(FilesTest, DroppedFilesOpenByWhatTheyHold) {
    write("square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    write("ray.json", R"({"fragments": [{"depth": 0, "opacity": 0.5}]})");
    ui::ExplorerState saved;
    saved.scene = "spheres";
    write("session.json", ui::session_to_json(saved).dump());
    write("broken.json", "{");
    open();
    play("drop square.obj");
    EXPECT_TRUE(state().scene.ends_with("square.obj")) << state().scene << message();
    play("drop ray.json");
    ASSERT_TRUE(state().ray) << message();
    EXPECT_EQ(state().ray->fragments.size(), 1u);
    play("drop session.json");
    EXPECT_EQ(state().scene, "spheres") << message();
    play("drop broken.json");
    EXPECT_NE(message().find("neither a session nor a lesson nor a view ray"), std::string::npos)
        << message();
    EXPECT_EQ(state().scene, "spheres");
}

TEST_F(FilesTest, AMeshThatLeavesNothingToSeeSaysSo) {
    write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    open();
    ui::choose_scene(workspace().state, (folder_ / "line.obj").string());
    settle();
    EXPECT_NE(state().scene, "planes");
    EXPECT_NE(message().find("shows almost nothing"), std::string::npos) << message();
}

TEST_F(FilesTest, WhileAMeshIsReadNothingElseChanges) {
    std::string mesh;
    for (int i = 0; i < 100'000; ++i) mesh += fmt::format("v {} {} {}\n", i % 997, i % 991, i % 983);
    for (int i = 1; i < 99'998; ++i) mesh += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    write("large.obj", mesh);
    write("ray.json", R"({"fragments": [{"depth": 0, "opacity": 0.5}]})");
    open();
    play("key P");
    ui::choose_scene(workspace().state, (folder_ / "large.obj").string());
    draw();
    ASSERT_TRUE(workspace().scene.is_reading());
    ImGuiIO& io = ImGui::GetIO();
    workspace().files.open_dropped("ray.json");
    draw();
    if (workspace().scene.is_reading()) {
        EXPECT_FALSE(state().ray) << "a dropped file waits for the mesh";
    }
    for (const int key : {int('P'), int('7'), int('L'), int('T')}) {
        io.KeysDown[key] = true;
        draw();
        io.KeysDown[key] = false;
        draw();
    }
    settle();
    EXPECT_FALSE(workspace().scene.is_reading());
    EXPECT_NE(state().scene, "planes") << message();
    EXPECT_TRUE(state().ray) << "the dropped file opens after the mesh";
    EXPECT_FALSE(state().lens);
    EXPECT_TRUE(state().pins.empty());
    EXPECT_EQ(measurement().pins.size(), 0u);
}

TEST_F(FilesTest, ADoubleClickOnAFolderOnlyEntersIt) {
    fs::create_directories("aaa");
    write("aaa/inner.json", ui::session_to_json(ui::ExplorerState()).dump());
    open("spheres", "trig2-32");
    play("key Ctrl+O\ndoubleclick @file.entry.aaa");
    EXPECT_TRUE(workspace().files.is_open());
    EXPECT_EQ(state().scene, "spheres");
    play("wait 1\nclick @file.entry.inner.json\nclick @file.accept");
    EXPECT_EQ(state().scene, "teapots");
}

TEST_F(FilesTest, EscapeClosesTheDialogAndKeepsTheCard) {
    open();
    play("click @card.order\nkey Ctrl+S\nkey Escape");
    EXPECT_FALSE(workspace().files.is_open());
    EXPECT_EQ(state().card, "order");
    play("key Escape");
    EXPECT_TRUE(state().card.empty());
}

}  // namespace
}  // namespace momentscope::test
