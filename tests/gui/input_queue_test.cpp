// input_queue_test.cpp -- mouse and keyboard events within one frame reach ImGui in several frames that it
// can distinguish.
#include "ui/window/input_queue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace momentscope::test {
namespace {

using Queue = ui::InputQueue;

// What ImGui sees in each frame until no event waits.
std::vector<ImGuiIO> frames_of(const std::vector<Queue::Event>& events) {
    Queue queue;
    for (const Queue::Event& event : events) queue.push(event);
    ImGuiIO io;
    std::vector<ImGuiIO> frames;
    while (!queue.empty()) {
        io.MouseWheel = 0;
        io.InputQueueCharacters.clear();
        queue.begin_frame(io);
        frames.push_back(io);
    }
    return frames;
}

TEST(InputQueueTest, AClickBetweenTwoFramesIsAPressAndARelease) {
    const auto frames = frames_of({Queue::Move{{3, 4}}, Queue::Button{0, true}, Queue::Button{0, false}});
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].MousePos.x, 3);
    EXPECT_TRUE(frames[0].MouseDown[0]);
    EXPECT_FALSE(frames[1].MouseDown[0]);
}

TEST(InputQueueTest, TwoClicksBetweenTwoFramesAreTwo) {
    const auto frames = frames_of(
        {Queue::Button{0, true}, Queue::Button{0, false}, Queue::Button{0, true}, Queue::Button{0, false}});
    ASSERT_EQ(frames.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(frames[i].MouseDown[0], i % 2 == 0) << i;
}

TEST(InputQueueTest, AClickBelongsToWhereTheMouseWas) {
    const auto frames = frames_of({Queue::Move{{1, 1}}, Queue::Move{{2, 2}}, Queue::Button{0, true},
                                   Queue::Button{0, false}, Queue::Move{{9, 9}}});
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].MousePos.x, 2) << "moves come together";
    EXPECT_EQ(frames[1].MousePos.x, 2);
    EXPECT_EQ(frames[2].MousePos.x, 9);
}

TEST(InputQueueTest, NotchesOfTheWheelAddUpWhereTheyWereTurned) {
    const auto frames = frames_of({Queue::Move{{1, 1}}, Queue::Wheel{{0, 1}}, Queue::Wheel{{0, 2}},
                                   Queue::Move{{5, 5}}, Queue::Wheel{{0, -1}}});
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].MousePos.x, 1);
    EXPECT_EQ(frames[0].MouseWheel, 3);
    EXPECT_EQ(frames[1].MouseWheel, -1);
}

// Ctrl+G and then 7, both typed while a picture was drawn.
TEST(InputQueueTest, AKeyHasTheModifiersThatWereDownWithIt) {
    constexpr int CTRL = 341;  // GLFW's number
    const auto frames = frames_of({Queue::Key{CTRL, true}, Queue::Key{'G', true}, Queue::Key{'G', false},
                                   Queue::Key{CTRL, false}, Queue::Key{'7', true}, Queue::Character{'7'},
                                   Queue::Key{'7', false}});
    int g = 0;
    int seven = 0;
    for (const ImGuiIO& io : frames) {
        g += io.KeysDown['G'] ? 1 : 0;
        EXPECT_TRUE(io.KeyCtrl || !io.KeysDown['G']);
        if (io.InputQueueCharacters.Size == 0) continue;
        ++seven;
        EXPECT_FALSE(io.KeyCtrl);
        EXPECT_TRUE(io.KeysDown['7']);
    }
    EXPECT_EQ(g, 1);
    EXPECT_EQ(seven, 1);
    EXPECT_FALSE(frames.back().KeysDown['7']);
}

TEST(InputQueueTest, UnknownKeysAndButtonsDoNothing) {
    const auto frames = frames_of(
        {Queue::Key{-1, true}, Queue::Key{100000, true}, Queue::Button{7, true}, Queue::Button{-1, true}});
    for (const bool down : frames.back().MouseDown) EXPECT_FALSE(down);
}

}  // namespace
}  // namespace momentscope::test
