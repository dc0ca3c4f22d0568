// lesson_test.cpp -- lessons in the window: answers, presenting, files, and what is kept for the next start.
#include <nlohmann/json.hpp>
#include <set>

#include "core/support/error.hpp"
#include "tests/gui/folder_fixture.hpp"
#include "ui/model/course.hpp"
#include "ui/model/lesson_file.hpp"

namespace momentscope::test {
namespace {

class LessonTest : public FolderTest {
protected:
    bool is_done(const char* lesson, std::size_t step) {
        return std::as_const(workspace().lesson.progress).of(lesson, step).done;
    }

    const std::string& feedback() { return workspace().lesson.feedback().sentence; }

    /// Opens the window with a host that keeps texts in `kept_`.
    void open_keeping(bool refuses = false) {
        window_.reset();
        ui::WindowOptions options{1, false};
        options.host.keep = [this, refuses](const std::string& name, const std::string& text) {
            ++writes_;
            if (refuses) throw Error("The folder is full.");
            kept_[name] = text;
        };
        options.host.kept = [this](const std::string& name) { return kept_[name]; };
        ui::ExplorerState state;
        state.scene = "planes";
        window_ = std::make_unique<HeadlessWindow>(shared_gl().context, shared_gl().programs, size_, state,
                                                   options, log_);
        settle();
    }

    std::map<std::string, std::string> kept_;
    int writes_ = 0;
};

TEST_F(LessonTest, AStepIsDoneWhenItsCheckHolds) {
    open("planes");
    play("click @card.order");
    EXPECT_FALSE(is_done("order", 0));
    play("click @parameter.order\nclick @parameter.order.shuffled");
    EXPECT_TRUE(is_done("order", 0));
    play("click @parameter.order\nclick @parameter.order.submitted");
    EXPECT_TRUE(is_done("order", 0)) << "and stays so";
}

TEST_F(LessonTest, AnswersAreJudgedAndNonsenseIsExplained) {
    open("planes");
    play("click @card.absorbance\nclick @card.typed\ntype about 2\nclick @card.check");
    EXPECT_NE(feedback().find("'about 2' is not a number"), std::string::npos) << feedback();
    EXPECT_EQ(std::as_const(workspace().lesson.progress).of("absorbance", 0).tries, 0) << "no answer yet";
    play("click @card.typed\nkey Ctrl+A\ntype 0.2\nkey Enter");
    EXPECT_NE(feedback().find("0.2 is too small"), std::string::npos) << feedback();
    EXPECT_FALSE(is_done("absorbance", 0));
    play("click @card.typed\nkey Ctrl+A\ntype 0.3\nkey Enter");
    EXPECT_NE(feedback().find("holds back"), std::string::npos) << "a mistake that the lesson knows";
    play("click @card.typed\nkey Ctrl+A\ntype 0,7\nkey Enter");
    EXPECT_TRUE(is_done("absorbance", 0)) << feedback();
    EXPECT_EQ(std::as_const(workspace().lesson.progress).of("absorbance", 0).tries, 3);
    EXPECT_EQ(std::as_const(workspace().lesson.progress).of("absorbance", 0).answer, "0,7");
}

TEST_F(LessonTest, TheRightNumberIsThatOfTheWindow) {
    open("planes");
    play("click @card.sum\ndrag @plot 0.65 0.5 to @plot 0.1 0.5");
    play("click @card.typed\ntype 1.204\nkey Enter");
    EXPECT_FALSE(is_done("sum", 0)) << "the query moved in front of all fragments";
    play("click @card.typed\nkey Ctrl+A\ntype 0\nkey Enter");
    EXPECT_TRUE(is_done("sum", 0)) << feedback();
}

TEST_F(LessonTest, UndoGoesBackAStep) {
    open("planes");
    play("click @card.moments\nclick @card.next");
    EXPECT_EQ(state().step, 1U);
    play("key Ctrl+Z");
    EXPECT_EQ(state().step, 0U);
    play("key Ctrl+Z");
    EXPECT_TRUE(state().card.empty());
}

TEST_F(LessonTest, WhatALessonHidesComesBackWithTheAnswer) {
    open("planes");
    play("click @card.causes");
    const auto hidden = screen();
    EXPECT_TRUE(ui::is_hidden(workspace(), ui::VERDICT));
    play("click @card.choice.1\nmove -10 -10");
    EXPECT_TRUE(is_done("causes", 0)) << feedback();
    EXPECT_FALSE(ui::is_hidden(workspace(), ui::VERDICT));
    EXPECT_GT(changed("fragments.verdict", hidden, screen()), 50);
}

TEST_F(LessonTest, ExperimentsDoNotChangeWhatIsRight) {
    open("planes");
    ui::go_to(workspace().state, {workspace().course.find("causes"), 4}, false);  // wrong because of rounding
    settle();
    workspace().state.parameters.set(ParameterId::alpha, 1e-3f);  // now it is bias
    settle();
    play("click @card.choice.4");
    EXPECT_FALSE(is_done("causes", 4)) << feedback();
    play("click @card.choice.5");
    EXPECT_TRUE(is_done("causes", 4)) << feedback();
}

TEST_F(LessonTest, TenStatesArePresentedByPageDownAlone) {
    open("planes");
    play("key F9\nkey PageDown");
    ASSERT_TRUE(workspace().present);
    EXPECT_FALSE(workspace().widget_rects.contains("tab.1"));
    EXPECT_FALSE(workspace().widget_rects.contains("menu.file"));
    EXPECT_TRUE(workspace().widget_rects.contains("plot"));
    EXPECT_TRUE(workspace().widget_rects.contains("scene"));
    EXPECT_TRUE(workspace().widget_rects.contains("card"));
    EXPECT_EQ(state().card, ui::own_lessons()[0].id);
    std::vector<ui::ExplorerState> shown = {state()};
    for (int i = 1; i < 10; ++i) {
        play("key PageDown");
        EXPECT_FALSE(workspace().moving.has_value()) << "the move has ended";
        EXPECT_TRUE(message().empty()) << message();
        for (const ui::ExplorerState& earlier : shown) EXPECT_NE(state(), earlier) << "state " << i;
        shown.push_back(state());
    }
    EXPECT_EQ(state().step, 4U) << "each step comes twice: as it starts, and solved";
    for (int i = 8; i >= 0; --i) {
        play("key PageUp");
        EXPECT_EQ(state(), shown[static_cast<std::size_t>(i)]) << "state " << i;
    }
    play("key Escape");
    EXPECT_FALSE(workspace().present);
    EXPECT_FALSE(state().card.empty());
}

TEST_F(LessonTest, PresentedStatesMoveUnlessThatIsOff) {
    open("planes");
    const auto frames_of = [&](const char* key) {
        const long before = window_->log().frames();
        play(key);
        return window_->log().frames() - before;
    };
    workspace().state.card = "beta";
    settle();
    play("key F9");
    const long moving = frames_of("key PageDown");
    EXPECT_EQ(state().parameters.number(ParameterId::beta), 0);
    workspace().settings.moves = false;
    const long jumping = frames_of("key PageUp");
    EXPECT_GT(moving, jumping + 20);
}

TEST_F(LessonTest, FilesAndFoldersOfLessonsOpen) {
    nlohmann::json lesson = {
        {"momentscope_lesson", 1}, {"id", "mine"}, {"title", "Mine"}, {"steps", {{{"do", "Look."}}}}};
    fs::create_directories("lessons");
    write("lessons/1.json", lesson.dump());
    lesson["id"] = "yours";
    write("lessons/2.json", lesson.dump());
    write("lessons/3.json", "{}");
    open("planes");
    play("drop lessons/2.json");
    EXPECT_EQ(state().card, "yours");
    EXPECT_TRUE(message().empty()) << message();
    play("drop lessons");
    EXPECT_EQ(state().card, "mine");
    EXPECT_NE(message().find("3.json"), std::string::npos) << message();
    EXPECT_EQ(workspace().course.lessons().size(), ui::own_lessons().size() + 2);
    play("drop lessons/3.json");
    EXPECT_EQ(state().card, "mine") << "a damaged file changes nothing";
    EXPECT_FALSE(message().empty());
}

TEST_F(LessonTest, AnswersAreExported) {
    open("planes");
    play("click @card.absorbance\nclick @card.typed\ntype 0.7\nkey Enter");
    play("click @menu.try\nclick @try.export\nkey Enter");
    const std::string text = read("answers.md");
    EXPECT_NE(text.find("*done*: 0.7"), std::string::npos) << text;
}

TEST_F(LessonTest, ProgressAndSettingsComeBack) {
    open_keeping();
    EXPECT_EQ(writes_, 0) << "nothing has changed";
    play("click @card.absorbance\nclick @card.typed\ntype 0.7\nkey Enter\nkey Ctrl+T\nkey Ctrl+Plus");
    const float scale = workspace().settings.text_scale;
    open_keeping();
    EXPECT_TRUE(is_done("absorbance", 0));
    EXPECT_EQ(workspace().settings.theme, ui::ThemeKind::light);
    EXPECT_EQ(workspace().settings.text_scale, scale);
}

TEST_F(LessonTest, WhatCannotBeKeptIsSaidOnceAndWhatIsDamagedIsNotReplaced) {
    open_keeping(true);
    play("key Ctrl+T");
    EXPECT_NE(message().find("full"), std::string::npos) << message();
    play("key Ctrl+T\nkey Ctrl+T");
    EXPECT_EQ(writes_, 1);
    kept_["progress"] = "{";
    open_keeping();
    EXPECT_FALSE(message().empty());
    play("click @card.order\nclick @parameter.order\nclick @parameter.order.shuffled");
    EXPECT_TRUE(is_done("order", 0)) << "it works without";
    EXPECT_EQ(kept_["progress"], "{");
}

TEST_F(LessonTest, NextFailedPixelsAreFarApartAndFailed) {
    ui::ExplorerState state;
    state.scene = "spheres";
    state.technique = &require_technique("power8-32");
    state.parameters.set(ParameterId::alpha, 0.0f);
    open(state);
    std::set<std::pair<int, int>> visited;
    for (int i = 0; i < 3; ++i) {
        play("key Shift+J");
        const glm::ivec2 pixel = measurement().pixel;
        EXPECT_TRUE(visited.insert({pixel.x, pixel.y}).second);
        const auto& failed = workspace().scene_picture.failures->failed_pixels;
        EXPECT_NE(std::ranges::find(failed, pixel), failed.end());
        EXPECT_GT(measurement().canonical.floored_pivots, 0) << "C++ finds the matrix singular, too";
    }
    workspace().state.technique = &require_technique("wboit");
    play("key Shift+J");
    EXPECT_NE(message().find("no moments"), std::string::npos) << message();
}

// As the guide shows them; each event file expects that every step is done.
TEST_F(LessonTest, FourLessonsAreTakenWithTheMouse) {
    for (const char* lesson : {"order", "moments", "bias", "choose"}) {
        SCOPED_TRACE(lesson);
        ui::ExplorerState fresh;
        fresh.scene = "planes";
        open(fresh);
        EXPECT_NO_THROW(play(read(before_ / fmt::format("docs/guide/lesson-{}.events", lesson))));
        EXPECT_TRUE(workspace().lesson.progress.is_done(*workspace().course.find(lesson)));
    }
}

// Step 0: the sums of the table are the moments that the pixel stores, in every basis.
TEST_F(LessonTest, DraggingAFragmentMovesItsMoments) {
    open("planes", "power4-32");
    play("key Ctrl+2\nclick @fragments.moments\nmove -10 -10");
    EXPECT_TRUE(workspace().widget_rects.contains("moments.1"));
    EXPECT_FALSE(workspace().widget_rects.contains("fragment.1"));
    play("key Ctrl+5\nclick @editor.preset\nclick @editor.preset.two\nmove -10 -10");
    const auto before = screen();
    play("drag @editor.fragment.1 to @editor.area 0.1 0.5\nmove -10 -10");
    EXPECT_GT(changed("moments", before, screen()), 100);
}

TEST_F(LessonTest, TextGrowsAndShrinks) {
    open("planes");
    const float before = ImGui::GetFontSize();
    play("key Ctrl+Plus\nkey Ctrl+Plus");
    EXPECT_NEAR(ImGui::GetFontSize(), 1.21f * before, 1);
    play("key Ctrl+0");
    EXPECT_EQ(ImGui::GetFontSize(), before);
}

}  // namespace
}  // namespace momentscope::test
