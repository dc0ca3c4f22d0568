// escape_test.cpp -- Escape closes only what was opened last.
#include "tests/gui/folder_fixture.hpp"

namespace momentscope::test {
namespace {

class EscapeTest : public FolderTest {
protected:
    static bool shows_popup() {
        return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    }
};

TEST_F(EscapeTest, ClosesAnOpenListBeforeAnythingElse) {
    open();
    play("click @card.order");
    for (const char* opener : {"click @controls.technique", "click @scene.views", "click @menu.view"}) {
        play(opener);
        ASSERT_TRUE(shows_popup()) << opener;
        play("key Escape");
        EXPECT_FALSE(shows_popup()) << opener;
        EXPECT_EQ(state().card, "order") << opener;
    }
    play("key Escape");
    EXPECT_TRUE(state().card.empty()) << "then what remains";
}

TEST_F(EscapeTest, ClosesTheListOfADialogBeforeTheDialog) {
    open();
    play("key Ctrl+E\nclick @file.kind\nkey Escape");
    EXPECT_TRUE(workspace().files.is_open());
    EXPECT_FALSE(workspace().widget_rects.contains("file.kind.ray_json"));
    play("key Escape");
    EXPECT_FALSE(workspace().files.is_open());
}

TEST_F(EscapeTest, AListThatIsClosedStaysUsable) {
    open();
    play(
        "click @controls.technique\nkey Escape\nclick @controls.technique\nclick @controls.technique.trig3-32");
    EXPECT_EQ(state().technique->id, std::string("trig3-32"));
}

// Refused text must not remain in front of the next typed text.
TEST_F(EscapeTest, GoToStartsAfreshAfterARefusal) {
    open();
    play("key Ctrl+G\ntype 99999, 3\nkey Enter\nexpect-message is not a pixel of the picture");
    play("key Ctrl+G\ntype 100, 90\nkey Enter");
    EXPECT_EQ(workspace().measurement().pixel, glm::ivec2(100, 90));
    EXPECT_TRUE(message().empty()) << message();
}

}  // namespace
}  // namespace momentscope::test
