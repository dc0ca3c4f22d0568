// session_test.cpp -- sessions, undo, files: nothing is lost, and nonsense is explained.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.hpp"
#include "core/ray/ray_json.hpp"
#include "tests/gui/gui_fixture.hpp"
#include "ui/commands.hpp"
#include "ui/lessons.hpp"
#include "ui/session.hpp"

namespace momentscope::test {
namespace {

namespace fs = std::filesystem;

class SessionTest : public GuiTest {
protected:
    SessionTest() {
        folder_ = fs::temp_directory_path() / fmt::format("momentscope-session-{}", ::getpid());
        fs::create_directories(folder_);
        before_ = fs::current_path();
        fs::current_path(folder_);  // where dialogs begin
    }
    ~SessionTest() override {
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

/// Changes as much as events can.
constexpr const char* EVENTFUL = R"(click @controls.technique
click @controls.technique.trig3-32
drag @parameter.beta 0.25 0.5 to @parameter.beta 0.7 0.5
drag @parameter.theta 0.1 0.5 to @parameter.theta 0.4 0.5
click @parameter.alpha 0.3 0.5
click @parameter.renormalize
drag @scene 0.4 0.4 to @scene 0.5 0.45 right
move @scene
wheel 1
click @scene 0.45 0.5
key P
click @scene 0.35 0.5
key P
key N
key L
key O
key X
key C
move @plot 0.4 0.4
wheel 2
drag @plot 0.5 0.5 to @plot 0.55 0.45 right
drag @split.scene to 600 400
key Ctrl+2
key Ctrl+T
move -10 -10
)";

TEST_F(SessionTest, ReopenedItDrawsTheSameBytes) {
    open("planes", "power4-32");
    play(EVENTFUL);
    play("key Ctrl+S\nkey Ctrl+A\ntype all.json\nkey Enter\nkey Escape\nmove -10 -10");
    ASSERT_TRUE(fs::exists(folder_ / "all.json")) << explorer().message();
    const auto first = screen();
    const ui::ExplorerState saved = state();
    open(ui::read_session_file(folder_ / "all.json").state);
    play("move -10 -10");
    EXPECT_EQ(state(), saved);
    EXPECT_EQ(screen(), first);
}

TEST_F(SessionTest, TheDialogOpensWhatItSaved) {
    open("planes", "power4-32");
    play(EVENTFUL);
    const ui::ExplorerState saved = state();
    play("key Ctrl+S\nkey Enter");
    play("key Escape");
    open("spheres", "sorted");
    play("key Ctrl+O\nclick @file.entry.momentscope.json\nclick @file.accept");
    EXPECT_EQ(state(), saved) << explorer().message();
}

TEST_F(SessionTest, SavingAsksBeforeItReplaces) {
    open();
    write("momentscope.json", "precious");
    play("key Ctrl+S\nkey Enter");
    EXPECT_EQ(read("momentscope.json"), "precious");
    play("click @file.cancel");
    EXPECT_EQ(read("momentscope.json"), "precious");
    play("key Ctrl+S\nclick @file.accept\nclick @file.accept");
    EXPECT_NE(read("momentscope.json"), "precious");
}

TEST_F(SessionTest, EveryExportIsWritten) {
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
        EXPECT_NE(explorer().message().find("Written to"), std::string::npos)
            << kind << ": " << explorer().message();
    }
    const auto curves = nlohmann::json::parse(read("out1.json"));
    EXPECT_EQ(curves["curves"][0]["reconstructed"].size(), measurement().curve.depth.size());
    EXPECT_EQ(ray_from_json(read("out3.json")).fragments.size(), measurement().capture.ray.fragments.size());
    const std::string fragments = read("out2.csv");
    EXPECT_EQ(std::ranges::count(fragments, '\n'), static_cast<long>(1 + measurement().history.size()));
    for (const char* picture : {"out4.png", "out5.exr", "out6.png"})
        EXPECT_GT(fs::file_size(picture), 1000u) << picture;
}

TEST_F(SessionTest, ARayFileIsPlotted) {
    write("ray.json", R"({"fragments": [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": 0.7}]})");
    open();
    play("key Ctrl+J\nclick @file.entry.ray.json\nclick @file.accept");
    ASSERT_TRUE(state().ray) << explorer().message();
    EXPECT_EQ(measurement().capture.ray.fragments.size(), 2u);
    play("key Ctrl+2\nclick @fragment.2\nkey P\nkey Home\nkey Left\nhold G\nlet G");
    EXPECT_EQ(state().marked, std::optional<std::size_t>(1));
    play("key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z");
    EXPECT_FALSE(state().ray) << "undone, the scene is back";
    EXPECT_EQ(measurement().capture.ray.fragments.size(), 4u);
}

TEST_F(SessionTest, BrokenSessionsAreExplainedAndChangeNothing) {
    open("spheres", "trig2-32");
    const ui::ExplorerState before = state();
    const auto good = nlohmann::json::parse(ui::session_to_json(before).dump());
    const auto with = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json changed = good;
        changed[nlohmann::json::json_pointer(pointer)] = value;
        return changed.dump();
    };
    const std::pair<std::string, const char*> broken[] = {
        {"", "not valid JSON"},
        {"[]", "must be an object"},
        {"{}", "no session of Momentscope"},
        {good.dump().substr(0, 200), "not valid JSON"},
        {with("/momentscope_session", 2), "has version 2"},
        {with("/momentscope_session", "1"), "no session"},
        {with("/technique", "power5"), "no technique 'power5'"},
        {with("/technique", 7), "id of a technique"},
        {with("/parameters/beta", 2), "beta"},
        {with("/parameters/beta", "auto"), "beta"},
        {with("/parameters/beta", nullptr), "beta"},
        {with("/picked", {0.5}), "picked"},
        {with("/picked", {2, 0}), "picked"},
        {with("/pins", {{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}}), "pins"},
        {with("/marked", -1), "marked"},
        {with("/plot/query", 3), "query"},
        {with("/plot/depth_range", {1, 0}), "depth_range"},
        {with("/plot/shown/truth", 1), "truth"},
        {with("/panel", "left"), "panel"},
        {with("/camera", {{"distance", 0}}), "distance"},
        {with("/camera", 3), "camera"},
        {with("/ray", {{"fragments", 3}}), "fragments"},
        {with("/card", "nope"), "card"},
        {with("/scene_share", 1e9), "scene_share"},
        {with("/scene", "/nowhere/mesh.obj"), "mesh.obj"},
        {std::string(100'000, '['), "nested"},
    };
    for (const auto& [text, said] : broken) {
        write("broken.json", text);
        play("key Ctrl+O\nclick @file.name\nkey Ctrl+A\ntype broken.json\nkey Enter\nmove -10 -10");
        EXPECT_NE(explorer().message().find(said), std::string::npos)
            << text.substr(0, 80) << "\nsays: " << explorer().message();
        EXPECT_EQ(state(), before) << text.substr(0, 80);
        play("key Escape\nkey Escape\nwait 1");
    }
}

TEST_F(SessionTest, MissingKeysAreStandardAndUnknownOnesAreNamed) {
    const ui::Session session = ui::session_from_json(
        R"({"momentscope_session": 1, "technique": "trig4-32", "flavour": 3, "plot": {"smell": 1}})");
    ui::ExplorerState expected;
    expected.technique = &require_technique("trig4-32");
    EXPECT_EQ(session.state, expected);
    EXPECT_EQ(session.ignored.size(), 2u);
    EXPECT_THROW(ui::read_session_file("/nowhere/x.json"), Error);
}

TEST_F(SessionTest, AHugeMeshCanBeCancelled) {
    // 400,000 triangles as text: long enough to read that the first frames find it loading.
    std::string mesh;
    for (int i = 0; i < 200'000; ++i) mesh += fmt::format("v {} {} {}\n", i % 997, i % 991, i % 983);
    for (int i = 1; i < 199'998; ++i)
        mesh += fmt::format("f {} {} {}\nf {} {} {}\n", i, i + 1, i + 2, i, i + 2, i + 1);
    write("huge.obj", mesh);
    open();
    const ui::ExplorerState before = state();
    ui::choose_scene(explorer().state(), (folder_ / "huge.obj").string());
    draw();
    ASSERT_TRUE(explorer().busy());
    draw();
    const ui::Rect cancel = explorer().anchors().at("loading.cancel");
    ImGui::GetIO().MousePos = {0.5f * (cancel.low.x + cancel.high.x), 0.5f * (cancel.low.y + cancel.high.y)};
    for (const bool down : {false, true, false}) {
        ImGui::GetIO().MouseDown[0] = down;
        draw();
    }
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_NE(explorer().message().find("cancelled"), std::string::npos) << explorer().message();
}

TEST_F(SessionTest, AFailedLoadIsNoStep) {
    write("broken.obj", "no mesh at all");
    open();
    play("key L\nkey Ctrl+M\nclick @file.entry.broken.obj\nclick @file.accept");
    EXPECT_EQ(state().scene, "planes");
    EXPECT_TRUE(state().lens);
    play("key Ctrl+Z");
    EXPECT_FALSE(state().lens) << "undo takes back what came before the failure";
    EXPECT_FALSE(explorer().can_undo());
    play("key Ctrl+Y");
    EXPECT_TRUE(state().lens);
}

// A mesh that vanished: undo cannot show its state, and must not trap the user there.
TEST_F(SessionTest, UndoToAVanishedMeshStaysUsable) {
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    open();
    play("key Ctrl+M\nclick @file.entry.triangle.obj\nclick @file.accept");
    ASSERT_NE(state().scene, "planes") << explorer().message();
    play("click @controls.scene\nclick @controls.scene.spheres");
    fs::remove("triangle.obj");
    play("key Ctrl+Z");
    EXPECT_EQ(state().scene, "spheres");
    EXPECT_NE(explorer().message().find("triangle.obj"), std::string::npos);
    play("key Ctrl+Z");
    EXPECT_EQ(state().scene, "planes") << "the state that cannot be shown is skipped";
}

TEST_F(SessionTest, WhileAMeshIsReadNothingElseChanges) {
    std::string mesh;
    for (int i = 0; i < 100'000; ++i) mesh += fmt::format("v {} {} {}\n", i % 997, i % 991, i % 983);
    for (int i = 1; i < 99'998; ++i) mesh += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    write("large.obj", mesh);
    write("ray.json", R"({"fragments": [{"depth": 0, "opacity": 0.5}]})");
    open();
    play("key P");
    ui::choose_scene(explorer().state(), (folder_ / "large.obj").string());
    draw();
    ASSERT_TRUE(explorer().busy());
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : {int('P'), int('7'), int('L'), int('T')}) {
        io.KeysDown[key] = true;
        draw();
        io.KeysDown[key] = false;
        draw();
    }
    settle();
    EXPECT_FALSE(explorer().busy());
    EXPECT_NE(state().scene, "planes") << explorer().message();
    EXPECT_FALSE(state().lens);
    EXPECT_TRUE(state().pins.empty());
    EXPECT_EQ(measurement().pins.size(), 0u);
}

TEST_F(SessionTest, UndoTakesBackOneStepEvenWhileAFieldIsOpen) {
    open();
    play("key X\nclick @scene.goto\nkey Ctrl+T\nclick 5 790");
    ASSERT_EQ(state().theme, ui::ThemeKind::light);
    play("key Ctrl+Z");
    EXPECT_EQ(state().theme, ui::ThemeKind::dark);
    EXPECT_TRUE(state().plot.shown[static_cast<std::size_t>(ui::Series::ghost)]);
    play("key L\nclick @scene.goto\ntype 12\nkey Ctrl+Z");
    EXPECT_TRUE(state().lens) << "Ctrl+Z belongs to the text that is typed";
}

TEST_F(SessionTest, ADoubleClickOnAFolderOnlyEntersIt) {
    fs::create_directories("aaa");
    write("aaa/inner.json", ui::session_to_json(ui::ExplorerState()).dump());
    open("spheres", "trig2-32");
    play("key Ctrl+O\ndoubleclick @file.entry.aaa");
    EXPECT_TRUE(explorer().shows_file_dialog());
    EXPECT_EQ(state().scene, "spheres");
    play("wait 1\nclick @file.entry.inner.json\nclick @file.accept");
    EXPECT_EQ(state().scene, "teapots");
}

TEST_F(SessionTest, EscapeClosesTheDialogAndKeepsTheCard) {
    open();
    play("click @card.beta\nkey Ctrl+S\nkey Escape");
    EXPECT_FALSE(explorer().shows_file_dialog());
    EXPECT_EQ(state().card, "beta");
    play("key Escape");
    EXPECT_TRUE(state().card.empty());
}

TEST_F(SessionTest, ANameThatIsNoUtf8IsExplained) {
    ui::ExplorerState state;
    state.scene = "m\xe9.obj";
    EXPECT_THROW(ui::write_session_file(state, folder_ / "s.json"), Error);
    EXPECT_FALSE(fs::exists(folder_ / "s.json"));
}

TEST_F(SessionTest, ParametersAreTypedFromTheKeyboardAlone) {
    open();
    play("key Ctrl+Shift+P\ntype type overestimation\nkey Enter\ntype 0.875\nkey Enter");
    EXPECT_EQ(state().parameters[ParameterId::beta], std::optional(0.875f)) << explorer().message();
}

TEST_F(SessionTest, ARayOfManyFragmentsIsDrawnWhole) {
    std::string fragments;
    for (int i = 0; i < 40'000; ++i)
        fragments +=
            fmt::format(R"({}{{"depth": {}, "opacity": 0.0001}})", i == 0 ? "" : ",", -1 + 2.0 * i / 40'000);
    write("many.json", fmt::format(R"({{"fragments": [{}]}})", fragments));
    open();
    play("key Ctrl+J\nclick @file.entry.many.json\nclick @file.accept\nmove -10 -10");
    ASSERT_TRUE(state().ray) << explorer().message();
    // Right of the middle the truth's ramp is above half its height: its light colour must be found there.
    const ui::Rect plot = explorer().anchors().at("plot");
    const auto pixels = screen();
    const int x = static_cast<int>(plot.low.x + 0.75f * (plot.high.x - plot.low.x));
    int bright = 0;
    for (int y = static_cast<int>(plot.low.y); y < static_cast<int>(0.5f * (plot.low.y + plot.high.y)); ++y)
        bright += pixels[4u * static_cast<unsigned>(y * size_.x + x)] > 150 ? 1 : 0;
    EXPECT_GT(bright, 0);
}

TEST(Lessons, EachIsReachedWithOneClickAndShowsItsSubject) {
    for (const ui::Lesson& lesson : ui::lessons()) {
        ui::ExplorerState state;
        open_lesson(state, lesson);
        EXPECT_EQ(state.card, lesson.id);
        EXPECT_EQ(ui::session_from_json(ui::session_to_json(state).dump()).state, state);
    }
}

// Undo brings the first state back whatever was done, and nothing that is done crashes.
TEST_F(SessionTest, UndoAfterRandomEventsRestoresTheFirstState) {
#ifdef MOMENTSCOPE_SANITIZE
    constexpr int SEQUENCES = 2;
#else
    constexpr int SEQUENCES = 6;
#endif
    for (int sequence = 0; sequence < SEQUENCES; ++sequence) {
        SCOPED_TRACE(fmt::format("sequence {}", sequence));
        std::mt19937 random(static_cast<unsigned>(7919 * sequence + 1));
        const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        open("planes", "power4-32");
        const ui::ExplorerState first = state();
        std::string played;
        for (int i = 0; i < 50; ++i) {
            const auto& anchors = explorer().anchors();
            auto anchor = anchors.begin();
            std::advance(anchor, static_cast<long>(below(anchors.size())));
            const auto share = [&] {
                return fmt::format("{:.2f}", 0.05 + 0.9 * static_cast<double>(below(100)) / 100);
            };
            const auto at = [&] { return fmt::format("@{} {} {}", anchor->first, share(), share()); };
            const auto anywhere = [&] { return fmt::format("{} {}", below(1280), below(800)); };
            const auto all = ui::commands();
            const auto& keys = all[below(all.size())].keys;
            constexpr const char* TEXTS[] = {"0.5", "nonsense", "β", "12, 30", "/", "1e30"};
            constexpr const char* BUTTONS[] = {"left", "right", "middle"};
            std::string event;
            switch (below(8)) {
                case 0:
                case 1:
                    event = "click " + at();
                    break;
                case 2:
                    event = "drag " + at() + " to " + anywhere() + " " + BUTTONS[below(3)];
                    break;
                case 3:
                    event = "move " + anywhere() + fmt::format("\nwheel {}", static_cast<int>(below(7)) - 3);
                    break;
                case 4:
                case 5:
                    if (!keys.empty() && keys.front() != "Ctrl+Z") event = "key " + keys[below(keys.size())];
                    break;
                case 6:
                    event = fmt::format("type {}", TEXTS[below(std::size(TEXTS))]);
                    break;
                default:
                    event = "doubleclick " + at();
                    break;
            }
            played += event + "\n";
            ASSERT_NO_THROW(play(event)) << played;
        }
        play(
            "release left\nrelease right\nrelease middle\nmove -10 -10\nkey Escape\nkey Escape\nkey "
            "Escape\nkey Escape");
        while (explorer().can_undo()) {
            explorer().undo();
            settle();
        }
        EXPECT_EQ(state(), first) << played;
    }
}

}  // namespace
}  // namespace momentscope::test
