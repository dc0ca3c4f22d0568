// selection_test.cpp -- what a change of the selection resets, without a window.
#include "ui/model/selection.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/ray/random_ray.hpp"

namespace momentscope::test {
namespace {

using ui::ExplorerState;

ViewRay two_fragments() {
    ViewRay ray;
    ray.fragments = {plain_fragment(-0.5f, 0.5f, 0), plain_fragment(0.5f, 0.5f, 1)};
    return ray;
}

/// A state with everything that a change may reset.
ExplorerState full_state() {
    ExplorerState state;
    state.camera = Camera();
    state.picked = glm::vec2(0.25f, 0.75f);
    state.pins = {{0.1f, 0.2f}};
    state.marked = 1;
    state.receiver = 0;
    state.plot.query = 0.3f;
    state.plot.depth = ui::Range{-0.5f, 0.5f};
    state.plot.value = ui::Range{0, 2};
    state.compare.region = ui::PictureRegion();
    return state;
}

/// Nothing of the previous ray is left.
void expect_new_ray(const ExplorerState& state) {
    EXPECT_FALSE(state.marked);
    EXPECT_FALSE(state.plot.query);
    EXPECT_FALSE(state.plot.depth);
    EXPECT_FALSE(state.plot.value);
}

TEST(Selection, EveryOtherRayTakesMarkQueryAndRangesWithIt) {
    const std::pair<const char*, std::function<void(ExplorerState&)>> changes[] = {
        {"open", [](ExplorerState& s) { ui::open_ray(s, two_fragments()); }},
        {"edit", [](ExplorerState& s) { ui::edit_ray(s, two_fragments()); }},
        {"leave", [](ExplorerState& s) { ui::leave_ray(s); }},
        {"scene", [](ExplorerState& s) { ui::choose_scene(s, "planes"); }},
    };
    for (const auto& [name, change] : changes) {
        SCOPED_TRACE(name);
        ExplorerState state = full_state();
        change(state);
        expect_new_ray(state);
    }
}

TEST(Selection, AnotherSceneResetsWhatBelongedToTheLastOne) {
    ExplorerState state = full_state();
    state.ray = two_fragments();
    ui::choose_scene(state, "planes");
    ExplorerState fresh;
    fresh.scene = "planes";
    EXPECT_EQ(state, fresh);
}

TEST(Selection, ARayKeepsThePlaceInTheScene) {
    ExplorerState state = full_state();
    ui::open_ray(state, two_fragments());
    ui::leave_ray(state);
    EXPECT_EQ(state.picked, full_state().picked);
    EXPECT_EQ(state.pins, full_state().pins);
    EXPECT_EQ(state.camera, full_state().camera);
}

TEST(Selection, AnotherPixelKeepsTheQueryDepth) {
    ExplorerState state = full_state();
    ui::pick(state, {0.5f, 0.5f});
    EXPECT_FALSE(state.marked);
    EXPECT_FALSE(state.receiver);
    EXPECT_EQ(state.plot.query, 0.3f) << "rays are compared at the same depth";
    ExplorerState same = full_state();
    ui::pick(same, *same.picked);
    EXPECT_EQ(same, full_state()) << "picking the same pixel changes nothing";
}

TEST(Selection, TheQueryGoesToAMarkedFragment) {
    ExplorerState state = full_state();
    ui::mark(state, std::nullopt);
    EXPECT_TRUE(state.plot.query) << "without a mark the query stays";
    ui::mark(state, 0);
    EXPECT_EQ(state.marked, 0u);
    EXPECT_FALSE(state.plot.query);
    ui::toggle_mark(state, 0);
    EXPECT_FALSE(state.marked);
    ui::toggle_mark(state, 1);
    EXPECT_EQ(state.marked, 1u);
}

TEST(Selection, TheLightTakesTheMarkAsItsReceiverAndGivesItBack) {
    ExplorerState state = full_state();
    ui::set_viewpoint(state, ui::Viewpoint::transparent_casters);
    EXPECT_TRUE(ui::seen_from_light(state)) << "shadows are on";
    EXPECT_EQ(state.receiver, 1u);
    expect_new_ray(state);
    state.marked = 0;
    ui::set_viewpoint(state, ui::Viewpoint::opaque_casters);
    EXPECT_FALSE(state.marked) << "it belonged to the other map";
    ui::set_viewpoint(state, ui::Viewpoint::eye);
    EXPECT_EQ(state.marked, 1u);
}

TEST(Selection, DeletingAFragmentNeedsAMarkInARay) {
    ExplorerState state = full_state();
    ui::delete_marked(state);
    EXPECT_EQ(state, full_state()) << "fragments of a scene stay";
    ui::open_ray(state, two_fragments());
    ui::delete_marked(state);
    EXPECT_EQ(state.ray->fragments.size(), 2u) << "nothing is marked";
    ui::mark(state, 0);
    ui::delete_marked(state);
    ASSERT_EQ(state.ray->fragments.size(), 1u);
    EXPECT_EQ(state.ray->fragments[0].depth, 0.5f);
    EXPECT_FALSE(state.marked);
}

TEST(Selection, OnlyFourPixelsCanBePinned) {
    ExplorerState state;
    ui::Measurement measurement;
    measurement.picture_size = {100, 100};
    for (int i = 0; i < 4; ++i) {
        ui::pick(state, {0.1f * static_cast<float>(i), 0.5f});
        EXPECT_TRUE(ui::toggle_pin(state, measurement));
    }
    ui::pick(state, {0.9f, 0.5f});
    EXPECT_FALSE(ui::toggle_pin(state, measurement));
    EXPECT_EQ(state.pins.size(), ui::MAX_PINS);
    ui::pick(state, state.pins[2]);
    EXPECT_TRUE(ui::toggle_pin(state, measurement)) << "a second time removes the pin";
    EXPECT_EQ(state.pins.size(), 3u);
}

}  // namespace
}  // namespace momentscope::test
