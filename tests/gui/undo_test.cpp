// undo_test.cpp -- every change can be undone, and a failed change is none.
#include <random>

#include "tests/effort.hpp"
#include "tests/gui/folder_fixture.hpp"
#include "ui/commands/commands.hpp"

namespace momentscope::test {
namespace {

class UndoTest : public FolderTest {
protected:
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
    std::string share() { return fmt::format("{:.2f}", 0.05 + 0.9 * static_cast<double>(below(100)) / 100); }
    std::string anywhere() { return fmt::format("{} {}", below(1280), below(800)); }

    /// An action on a random control of the current window.
    std::string on_a_control() {
        const auto& widget_rects = workspace().widget_rects;
        auto anchor = widget_rects.begin();
        std::advance(anchor, static_cast<long>(below(widget_rects.size())));
        return fmt::format("@{} {} {}", anchor->first, share(), share());
    }
    /// The key of a random command except undo; "" if the command has no key.
    std::string key_event() {
        const auto all = ui::commands();
        const auto& keys = all[below(all.size())].keys;
        return keys.empty() || keys.front() == "Ctrl+Z" ? "" : "key " + keys[below(keys.size())];
    }
    std::string random_event() {
        constexpr const char* TEXTS[] = {"0.5", "nonsense", "β", "12, 30", "/", "1e30"};
        constexpr const char* BUTTONS[] = {"left", "right", "middle"};
        switch (below(8)) {
            case 0:
            case 1:
                return "click " + on_a_control();
            case 2:
                return "drag " + on_a_control() + " to " + anywhere() + " " + BUTTONS[below(3)];
            case 3:
                return "move " + anywhere() + fmt::format("\nwheel {}", static_cast<int>(below(7)) - 3);
            case 4:
            case 5:
                return key_event();
            case 6:
                return fmt::format("type {}", TEXTS[below(std::size(TEXTS))]);
            default:
                return "doubleclick " + on_a_control();
        }
    }

    std::mt19937 random_;
};

TEST_F(UndoTest, AFailedLoadIsNoStep) {
    write("broken.obj", "no mesh at all");
    open();
    play("key L\nkey Ctrl+M\nclick @file.entry.broken.obj\nclick @file.accept");
    EXPECT_EQ(state().scene, "planes");
    EXPECT_TRUE(state().lens);
    play("key Ctrl+Z");
    EXPECT_FALSE(state().lens) << "undo takes back what came before the failure";
    EXPECT_FALSE(workspace().history.can_undo());
    play("key Ctrl+Y");
    EXPECT_TRUE(state().lens);
}

// A mesh file has vanished: undo cannot show its state, and must not trap the user there.
TEST_F(UndoTest, ToAVanishedMeshStaysUsable) {
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    open();
    play("key Ctrl+M\nclick @file.entry.triangle.obj\nclick @file.accept");
    ASSERT_NE(state().scene, "planes") << message();
    play("click @controls.scene\nclick @controls.scene.spheres");
    fs::remove("triangle.obj");
    play("key Ctrl+Z");
    EXPECT_EQ(state().scene, "spheres");
    EXPECT_NE(message().find("triangle.obj"), std::string::npos);
    play("key Ctrl+Z");
    EXPECT_EQ(state().scene, "planes") << "the state that cannot be shown is skipped";
}

TEST_F(UndoTest, TakesBackOneStepEvenWhileAFieldIsOpen) {
    open();
    play("key X\nclick @scene.goto\nkey Ctrl+T\nclick 5 790");
    ASSERT_EQ(state().theme, ui::ThemeKind::light);
    play("key Ctrl+Z");
    EXPECT_EQ(state().theme, ui::ThemeKind::dark);
    EXPECT_TRUE(state().plot.shown[static_cast<std::size_t>(ui::Series::unbiased_exact)]);
    play("key L\nclick @scene.goto\ntype 12\nkey Ctrl+Z");
    EXPECT_TRUE(state().lens) << "Ctrl+Z belongs to the text that is typed";
}

// Undo brings back the first state after any sequence of actions, and no action crashes.
TEST_F(UndoTest, AfterRandomEventsRestoresTheFirstState) {
    const int sequences = effort(2, 10);
    for (int sequence = 0; sequence < sequences; ++sequence) {
        SCOPED_TRACE(fmt::format("sequence {}", sequence));
        random_.seed(static_cast<unsigned>(7919 * sequence + 1));
        open("planes", "power4-32");
        const ui::ExplorerState first = state();
        std::string played;
        for (int i = 0; i < 50; ++i) {
            const std::string event = random_event();
            played += event + "\n";
            ASSERT_NO_THROW(play(event)) << played;
        }
        play("release left\nrelease right\nrelease middle\nmove -10 -10");
        play("key Escape\nkey Escape\nkey Escape\nkey Escape");
        EXPECT_NE(state(), first) << "events that change nothing test nothing";
        while (workspace().history.can_undo()) {
            ui::undo(workspace());
            settle();
        }
        EXPECT_EQ(state(), first) << played;
    }
}

}  // namespace
}  // namespace momentscope::test
