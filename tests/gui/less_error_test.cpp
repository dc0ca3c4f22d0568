// less_error_test.cpp -- the last steps of the lesson on beta: four clicks from the published estimate to the
// least error (docs/less_error.md).
#include <fmt/format.h>

#include <vector>

#include "tests/gui/gui_fixture.hpp"
#include "ui/model/course.hpp"

namespace momentscope::test {
namespace {

class LessErrorTest : public GuiTest {};

TEST_F(LessErrorTest, TheNumberOfTheLessonFallsWithEachClick) {
    const ui::Course course;
    const ui::Lesson& lesson = *course.find("beta");
    ui::ExplorerState first;
    ui::go_to(first, {&lesson, lesson.steps.size() - 2}, false);
    first.parameters.set(Estimate::beta);
    open(first);
    ASSERT_EQ(first.technique->id, std::string("cheb4-32"));
    std::vector<double> errors = {measurement().breakdown.error};
    for (const auto& [key, value] : {std::pair("estimate", "expected"), std::pair("ends", "known"),
                                     std::pair("interval", "pixel"), std::pair("renormalize", "uncertain")}) {
        play(fmt::format("click @parameter.{0}\nclick @parameter.{0}.{1}", key, value));
        EXPECT_TRUE(message().empty()) << message();
        errors.push_back(measurement().breakdown.error);
    }
    fmt::print("off by {:.4f}, {:.4f}, {:.4f}, {:.4f}, {:.4f}\n", errors[0], errors[1], errors[2], errors[3],
               errors[4]);
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], errors[i - 1]) << "click " << i;
    play("key Ctrl+2");
    EXPECT_FALSE(measurement().history.empty());
    for (const PixelHistoryRow& row : measurement().history) {
        ASSERT_TRUE(row.estimate.has_value());
        EXPECT_LE(row.estimate->lower, row.estimate->upper);
    }
    EXPECT_EQ(state().technique->id, std::string("cheb4-32"));
}

// Combinations that make no sense cannot be chosen, and say why.
TEST_F(LessErrorTest, WhatMakesNoSenseIsRefused) {
    open("teapots", "power6-32");
    play("click @parameter.interval\nclick @parameter.interval.pixel\nkey Escape");
    EXPECT_EQ(state().parameters.get<MomentInterval>(), MomentInterval::scene) << "the ends are not known";
    play("click @parameter.renormalize\nclick @parameter.renormalize.uncertain\nkey Escape");
    EXPECT_EQ(state().parameters.get<Renormalization>(), Renormalization::uniform) << "by beta";
}

}  // namespace
}  // namespace momentscope::test
