// lesson_test.cpp -- lessons that are wrong are named with what is wrong, the page about lessons is right,
// and answers are judged.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/inspect/error_causes.hpp"
#include "core/support/error.hpp"
#include "ui/model/course.hpp"
#include "ui/model/glossary.hpp"
#include "ui/model/lesson_file.hpp"
#include "ui/model/progress.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/settings.hpp"
#include "ui/model/transition.hpp"

namespace momentscope::test {
namespace {

std::string page() {
    std::ifstream file("docs/lessons.md");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string example() {
    const std::string text = page();
    const std::size_t begin = text.find("```json\n") + 8;
    return text.substr(begin, text.find("```", begin) - begin);
}

// What reading says; "" if it is a lesson.
std::string said_of(const std::string& text) {
    try {
        ui::lesson_from_json(text, "x.json");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(LessonFile, ThePageHasALessonAndAllNames) {
    const ui::Lesson lesson = ui::lesson_from_json(example(), "example");
    EXPECT_EQ(lesson.id, "two-sheets");
    EXPECT_EQ(lesson.steps.at(0).checks.size(), 2U);
    const std::string text = page();
    for (const std::string_view cause : cause::ALL) EXPECT_NE(text.find(cause), std::string::npos) << cause;
    for (const ui::MeasureRow& row : ui::MEASURES)
        EXPECT_NE(text.find(std::string("| `") + row.key + "` | " + row.help + " |"), std::string::npos)
            << row.key;
}

TEST(LessonFile, WhatIsWrongIsNamed) {
    const nlohmann::json good = nlohmann::json::parse(example());
    ASSERT_EQ(said_of(good.dump()), "");
    const auto with = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json changed = good;
        changed[nlohmann::json::json_pointer(pointer)] = value;
        return changed.dump();
    };
    const std::pair<std::string, const char*> wrong[] = {
        {"", "not valid JSON"},
        {"[]", "must be an object"},
        {"{}", "is not a lesson"},
        {with("/momentscope_lesson", 2), "has version 2"},
        {with("/id", "Two Sheets"), "small letters"},
        {with("/title", ""), "\"title\""},
        {with("/title", std::string(20'000, 'x')), "80 characters"},
        {with("/title", "two\nlines"), "80 characters"},
        {with("/steps/0/solution/choose", 2), "no choice"},
        {with("/steps/0/solution/session/panel", "left"), "step 1: the solution"},
        {with("/session/panel", "left"), "the session"},
        {with("/steps/0/check/1/mistakes", {{{"is", 1}}}), "why"},
        {with("/text", "[[nonsense]]"), "no term 'nonsense'"},
        {with("/flavour", 1), "no key \"flavour\""},
        {with("/steps", nlohmann::json::array()), "1 to 30 steps"},
        {with("/session/scene", "nowhere.obj"), "needs the scene 'nowhere.obj'"},
        {with("/session/panels", 1), "no \"panels\""},
        {with("/session/technique", "power5"), "no technique 'power5'"},
        {with("/steps/0/anwser", "x"), "step 1: there is no key \"anwser\""},
        {with("/steps/0/session/panel", "left"), "panel"},
        {with("/steps/0/hide", {"the truth"}), "\"hide\""},
        {with("/steps/0/check", nlohmann::json::object()), "names nothing"},
        {with("/steps/0/check/0/state", "/parameters/gamma"), "no '/parameters/gamma'"},
        {with("/steps/0/check/0/state", "beta"), "no 'beta'"},
        {with("/steps/0/check/0", {{"state", "/parameters/beta"}}), "\"is\", \"at_least\" or \"at_most\""},
        {with("/steps/0/check/0", {{"measure", "weight"}, {"is", 1}}), "must be one of fragments"},
        {with("/steps/0/check/1/within", 0), "within"},
        {with("/steps/0/check/0/choice", {1, 2}), "two kinds"},
        {with("/steps/0/check", {{"choice", {{{"text", "a"}, {"why", "b"}}}}}), "2 to 8 options"},
        {with("/steps/0/check", {{"choice", {{{"text", "a"}, {"why", "b"}}, {{"text", "c"}, {"why", "d"}}}}}),
         "exactly one"},
        {with("/steps/0/check", {{"choice",
                                  {{{"text", "a"}, {"why", "b"}, {"cause", "the moon"}},
                                   {{"text", "c"}, {"why", "d"}, {"cause", "the moment bias"}}}}}),
         "the moment bias"},
        {with("/steps/0/check/2", {{"text", 3}}), "only one check"},
        {with("/steps/0/solution/choose", 0), "choose"},
        {with("/steps/0/check", {{"state", "/parameters/beta"}, {"is", 1}}), "asks for no number"},
        {with("/steps/0/wrong", 3), "\"wrong\""},
        {std::string(1U << 20, ' '), "larger"},
        {std::string(100'000, '['), "nested"},
    };
    for (const auto& [text, what] : wrong) {
        const std::string said = said_of(text);
        EXPECT_NE(said.find(what), std::string::npos) << text.substr(0, 200) << "\nsays: " << said;
        EXPECT_NE(said.find("'x.json'"), std::string::npos) << said;
    }
}

TEST(Lesson, TypedNumbers) {
    for (const auto& [text, value] :
         {std::pair("0.25", 0.25), std::pair(" -1,5 ", -1.5), std::pair("1e-3", 1e-3)})
        EXPECT_EQ(ui::typed_number(text), value) << text;
    for (const char* text : {"", "about 2", "1/2", "nan", "inf", "0.2 or 0.3", "1,000.5"})
        EXPECT_THROW(ui::typed_number(text), Error) << text;
}

TEST(Lesson, LimitsHold) {
    ui::Limits near;
    near.is = 2;
    near.within = 0.1;
    EXPECT_TRUE(near.hold(2.05));
    EXPECT_FALSE(near.hold(2.15));
    EXPECT_FALSE(near.hold(std::nan("")));
    ui::Limits between;
    between.at_least = 1;
    between.at_most = 2;
    EXPECT_TRUE(between.hold(2));
    EXPECT_FALSE(between.hold(0.5));
}

TEST(Course, GoesThroughAllStepsAndBack) {
    const ui::Course course;
    std::size_t steps = 0;
    for (const ui::Lesson& lesson : course.lessons()) steps += lesson.steps.size();
    ui::StepPlace place = {&course.lessons().front(), 0};
    std::size_t forward = 1;
    for (auto next = course.next(place); next; next = course.next(place), ++forward) place = *next;
    EXPECT_EQ(forward, steps);
    std::size_t back = 1;
    for (auto previous = course.previous(place); previous; previous = course.previous(place), ++back)
        place = *previous;
    EXPECT_EQ(back, steps);
    EXPECT_EQ(place.lesson, &course.lessons().front());
}

TEST(Glossary, TermsHaveMeaningsWithoutMarks) {
    EXPECT_GT(ui::glossary().size(), 40U);
    for (const ui::GlossaryEntry& entry : ui::glossary()) {
        EXPECT_FALSE(entry.term.empty());
        EXPECT_GT(entry.meaning.size(), 20U) << entry.term;
        for (const char* sign : {"](", "`", " *", ".md"})
            EXPECT_EQ(entry.meaning.find(sign), std::string::npos) << entry.term << ": " << entry.meaning;
    }
    EXPECT_NE(ui::find_term("Depth")->meaning.find("lies in [-1, 1]"), std::string::npos);
    EXPECT_NE(ui::find_term("Bias")->meaning.find("α b_0 b*"), std::string::npos)
        << ui::find_term("Bias")->meaning;
    ASSERT_NE(ui::find_term("moment bias"), nullptr);
    EXPECT_EQ(ui::find_term("moment bias"), ui::find_term("Bias"));
    EXPECT_EQ(ui::find_term("nothing"), nullptr);
}

TEST(Glossary, RunsOfAText) {
    const auto runs = ui::text_runs("A **bold [[bounds|band]]**.\n\nNext");
    ASSERT_EQ(runs.size(), 5U);
    EXPECT_TRUE(runs[1].bold);
    EXPECT_EQ(runs[2].text, "band");
    EXPECT_EQ(runs[2].entry, ui::find_term("bounds"));
    EXPECT_TRUE(runs[4].paragraph);
    EXPECT_FALSE(runs[3].bold);
    EXPECT_EQ(ui::without_marks("A **bold [[bounds|band]]**."), "A bold band.");
    EXPECT_NO_THROW(ui::text_runs("[[unfinished"));
}

TEST(Progress, ComesBackAndIsCounted) {
    ui::Progress progress;
    const ui::Lesson& lesson = ui::own_lessons().front();
    EXPECT_FALSE(progress.is_done(lesson));
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        progress.of(lesson.id, i) = {true, 2, "because | so"};
    EXPECT_TRUE(progress.is_done(lesson));
    EXPECT_EQ(ui::progress_from_json(ui::progress_to_json(progress).dump()), progress);
    const std::string text = ui::answers_text(ui::own_lessons(), progress);
    EXPECT_NE(text.find("Order matters (done)"), std::string::npos) << text;
    EXPECT_NE(text.find("2 tries"), std::string::npos);
    for (const char* broken : {"", "{}", "[1]", R"({"momentscope_progress": 1, "lessons": {"a": 3}})"})
        EXPECT_THROW(ui::progress_from_json(broken), Error) << broken;
}

TEST(Settings, ComeBack) {
    const ui::Settings settings = {ui::ThemeKind::light, 1.25f, {1024, 700}, false, false};
    EXPECT_EQ(ui::settings_from_json(ui::settings_to_json(settings).dump()), settings);
    for (const char* broken : {"", "{}", R"({"momentscope_settings": 1, "text_scale": 99})"})
        EXPECT_THROW(ui::settings_from_json(broken), Error) << broken;
}

TEST(Transition, MovesNumbersAndEndsAtTheGoal) {
    ui::ExplorerState from;
    from.parameters.set(ParameterId::beta, 0.0f);
    from.plot.query = -0.5f;
    ui::ExplorerState to = from;
    to.parameters.set(ParameterId::beta, 1.0f);
    to.plot.query = 0.5f;
    to.panel = ui::Panel::steps;
    const ui::ExplorerState half = ui::between(from, to, 0.5f);
    EXPECT_FLOAT_EQ(*half.parameters[ParameterId::beta], 0.5f);
    EXPECT_FLOAT_EQ(*half.plot.query, 0);
    EXPECT_EQ(half.panel, ui::Panel::steps);
    EXPECT_EQ(ui::between(from, to, 1), to);
}

}  // namespace
}  // namespace momentscope::test
