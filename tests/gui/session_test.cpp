// session_test.cpp -- sessions lose nothing, and broken sessions are explained.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/support/error.hpp"
#include "tests/gui/folder_fixture.hpp"
#include "ui/model/course.hpp"
#include "ui/model/session.hpp"

namespace momentscope::test {
namespace {

class SessionTest : public FolderTest {};

/// Changes as much as events can. Changes that make every picture slow, such as shadows and a reference, come
/// last.
constexpr const char* EVENTFUL = R"(drag @split.scene to 600 400
click @controls.technique
click @controls.technique.trig3-32
drag @parameter.beta 0.25 0.5 to @parameter.beta 0.7 0.5
drag @parameter.theta 0.1 0.5 to @parameter.theta 0.4 0.5
click @parameter.alpha 0.3 0.5
click @parameter.renormalize
click @parameter.renormalize.off
drag @scene 0.4 0.4 to @scene 0.5 0.45 right
move @scene
wheel 1
click @scene 0.45 0.5
key P
click @scene 0.35 0.5
key P
key N
key L
key Shift+L
key X
key C
key V
move @plot 0.4 0.4
wheel 2
drag @plot 0.5 0.5 to @plot 0.55 0.45 right
key Ctrl+2
key Ctrl+T
key O
key W
key Shift+W
move -10 -10
)";

TEST_F(SessionTest, ReopenedItDrawsTheSameBytes) {
    open("planes", "power4-32");
    play(EVENTFUL);
    play("key Ctrl+S\nkey Ctrl+A\ntype all.json\nkey Enter\nkey Escape\nmove -10 -10");
    ASSERT_TRUE(fs::exists(folder_ / "all.json")) << message();
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
    EXPECT_EQ(state(), saved) << message();
}

TEST_F(SessionTest, BrokenSessionsAreExplainedAndChangeNothing) {
    open("planes", "trig2-32");
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
        {"{}", "not a session of Momentscope"},
        {good.dump().substr(0, 200), "not valid JSON"},
        {with("/momentscope_session", 2), "has version 2"},
        {with("/momentscope_session", "1"), "not a session"},
        {with("/technique", "power5"), "no technique 'power5'"},
        {with("/technique", 7), "id of a technique"},
        {with("/parameters/beta", 2), "beta"},
        {with("/parameters/beta", "auto"), "beta"},
        {with("/parameters/beta", nullptr), "beta"},
        {with("/picked", {0.5}), "picked"},
        {with("/picked", {2, 0}), "picked"},
        {with("/pins", {{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}}), "pins"},
        {with("/marked", -1), "marked"},
        {with("/receiver", "x"), "receiver"},
        {with("/viewpoint", "moon"), "viewpoint"},
        {with("/plot/query", 3), "query"},
        {with("/compare/reference", "perfect"), "no technique 'perfect'"},
        {with("/compare/mode", "sideways"), "mode"},
        {with("/compare/metric", "psnr"), "no metric 'psnr'"},
        {with("/compare/gain", 0), "gain"},
        {with("/compare/divider", 2), "divider"},
        {with("/compare/region", {0.5, 0.1, 0.4, 0.9}), "region"},
        {with("/lens_zoom", "huge"), "lens_zoom"},
        {with("/plot/depth_range", {1, 0}), "depth_range"},
        {with("/plot/shown/truth", 1), "truth"},
        {with("/panel", "left"), "panel"},
        {with("/camera", {{"distance", 0}}), "distance"},
        {with("/camera", 3), "camera"},
        {with("/ray", {{"fragments", 3}}), "fragments"},
        {with("/step", -1), "step"},
        {with("/scene_share", 1e9), "scene_share"},
        {with("/scene", "/nowhere/mesh.obj"), "mesh.obj"},
        {std::string(100'000, '['), "nested"},
    };
    for (const auto& [text, said] : broken) {
        write("broken.json", text);
        play("key Ctrl+O\nclick @file.name\nkey Ctrl+A\ntype broken.json\nkey Enter\nmove -10 -10");
        EXPECT_NE(message().find(said), std::string::npos) << text.substr(0, 80) << "\nsays: " << message();
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
    nlohmann::json many = {{"momentscope_session", 1}, {std::string(1000, 'k'), 0}};
    for (int i = 0; i < 100; ++i) many[fmt::format("x{}", i)] = i;
    const auto ignored = ui::session_from_json(many.dump()).ignored;
    EXPECT_EQ(ignored.size(), 20u) << "a message names some";
    EXPECT_EQ(ignored.front().size(), 60u);
    EXPECT_THROW(ui::read_session_file("/nowhere/x.json"), Error);
}

// A session beside the mesh stores the mesh's file name; elsewhere it stores an absolute path. Both find the
// mesh.
TEST_F(SessionTest, AMeshIsNamedSoThatTheSessionOpensFromEveryFolder) {
    fs::create_directories(folder_ / "meshes");
    std::ofstream(folder_ / "meshes" / "m.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    ui::ExplorerState state;
    state.scene = fs::relative(folder_ / "meshes" / "m.obj").string();
    const auto saved_name = [&](const fs::path& session) {
        ui::write_session_file(state, session);
        EXPECT_EQ(ui::read_session_file(session).state.scene, (folder_ / "meshes" / "m.obj").string());
        std::ifstream file(session);
        return nlohmann::json::parse(file)["scene"].get<std::string>();
    };
    EXPECT_EQ(saved_name(folder_ / "meshes" / "s.json"), "m.obj");
    EXPECT_EQ(saved_name(folder_ / "s.json"), "meshes/m.obj");
    fs::create_directories(folder_ / "sessions");
    EXPECT_EQ(saved_name(folder_ / "sessions" / "s.json"), (folder_ / "meshes" / "m.obj").string());
    state.scene = "planes";
    ui::write_session_file(state, folder_ / "s.json");
    EXPECT_EQ(ui::read_session_file(folder_ / "s.json").state.scene, "planes");
}

TEST_F(SessionTest, ANameThatIsNoUtf8IsExplained) {
    ui::ExplorerState state;
    state.scene = "m\xe9.obj";
    EXPECT_THROW(ui::write_session_file(state, folder_ / "s.json"), Error);
    EXPECT_FALSE(fs::exists(folder_ / "s.json"));
}

TEST_F(SessionTest, ALessonThatIsNotHereIsNamedAndClosed) {
    open("planes");
    ui::ExplorerState other = state();
    other.card = "of-somebody-else";
    ui::write_session_file(other, folder_ / "s.json");
    play("key Ctrl+O\nclick @file.name\nkey Ctrl+A\ntype s.json\nkey Enter\nmove -10 -10");
    EXPECT_NE(message().find("no lesson 'of-somebody-else'"), std::string::npos) << message();
    EXPECT_TRUE(state().card.empty());
}

TEST(Lessons, EachStepIsASession) {
    for (const ui::Lesson& lesson : ui::own_lessons())
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            const ui::ExplorerState state = ui::lesson_state(lesson, step, false, {});
            EXPECT_EQ(state.card, lesson.id);
            EXPECT_EQ(ui::session_from_json(ui::session_to_json(state).dump()).state, state);
        }
}

}  // namespace
}  // namespace momentscope::test
