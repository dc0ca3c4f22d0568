// link_test.cpp -- links hold every state, and say what is wrong with them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/ray/random_ray.hpp"
#include "core/support/error.hpp"
#include "ui/model/embedding.hpp"
#include "ui/model/link.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {
namespace {

template <typename T, std::size_t N>
T one_of(RandomNumbers& random, const T (&choices)[N]) {
    return choices[random.whole(0, static_cast<int>(N) - 1)];
}

ExplorerState random_state(RandomNumbers& random) {
    constexpr const char* SCENES[] = {"planes", "spheres", "ties", "cloud", "ship"};
    ExplorerState state;
    state.scene = one_of(random, SCENES);
    if (random.whole(0, 3) == 0) {  // as a user opens it, without what a file does not say
        const int count = random.whole(1, 9);
        open_ray(state, ray_from_value(ray_to_json(random_ray(random, count))));
    }
    state.technique =
        &require_technique(one_of(random, {"power4-32", "trig3-32", "sharp6", "sorted", "mt", "at"}));
    if (random.whole(0, 1) == 0) state.compared = {&require_technique("cheb6-32")};
    for (const Parameter& row : parameters())
        if (random.whole(0, 3) == 0 && row.choices.empty() && row.scale == Scale::linear)
            state.parameters.set(row.id, random.uniform(row.minimum, row.maximum));
    state.lens = random.whole(0, 1) == 0;
    state.panel = PANELS[static_cast<std::size_t>(random.whole(0, static_cast<int>(PANELS.size()) - 1))].id;
    state.theme = one_of(random, {ThemeKind::dark, ThemeKind::light});
    if (random.whole(0, 1) == 0) state.plot.depth = Range{random.uniform(-1, 0), random.uniform(0, 1)};
    if (random.whole(0, 1) == 0) state.plot.query = random.uniform(-1, 1);
    if (random.whole(0, 1) == 0) state.compare.gain = random.uniform(1, 64);
    if (random.whole(0, 1) == 0) state.picked = glm::vec2(random.point(glm::vec3(0), glm::vec3(1)));
    state.scene_share = random.uniform(0.2f, 0.8f);
    return state;
}

TEST(Link, HoldsEveryState) {
    RandomNumbers random(23);
    for (int i = 0; i < 200; ++i) {
        const ExplorerState state = random_state(random);
        EXPECT_EQ(session_from_json(link_text(state)).state, state) << link_text(state);
    }
}

TEST(Link, OfAFreshWindowIsShort) {
    EXPECT_EQ(link_text(ExplorerState()), R"({"momentscope_session":1})");
    ExplorerState state;
    state.parameters.set(ParameterId::beta, 0.5f);
    EXPECT_EQ(link_text(state), R"({"parameters":{"beta":0.5},"momentscope_session":1})");
}

TEST(Link, InWords) {
    const ExplorerState state = state_of_words("scene=ship&technique=trig2-32&theta=0.5&solver=textbook", {});
    EXPECT_EQ(state.scene, "ship");
    EXPECT_EQ(state.technique->id, std::string("trig2-32"));
    EXPECT_EQ(state.parameters[ParameterId::theta], 0.5f);
    EXPECT_EQ(state_of_words("", state), state);
    EXPECT_EQ(state_of_words("lesson=bias", {}).card, "bias");
    EXPECT_THROW(state_of_words("lesson=nonsense", {}), Error);
    for (const char* wrong :
         {"scene=moon", "technique=magic", "beta=2", "beta=", "beta", "=1", "gamma=1", "&beta=0"})
        EXPECT_THROW(state_of_words(wrong, {}), Error) << wrong;
}

TEST(Embedding, NamesPartsAndControls) {
    EXPECT_EQ(parse_embedding("", "").shown, Shown::window);
    EXPECT_EQ(parse_embedding("scene", "").shown, Shown::scene);
    const Embedding steps = parse_embedding("steps", "beta,alpha");
    EXPECT_EQ(steps.panel, Panel::steps);
    EXPECT_EQ(steps.controls, (std::vector{ParameterId::beta, ParameterId::alpha}));
    EXPECT_THROW(parse_embedding("cellar", ""), Error);
    EXPECT_THROW(parse_embedding("plot", "volume"), Error);
    EXPECT_THROW(parse_embedding("plot", "beta,,alpha"), Error);
}

}  // namespace
}  // namespace momentscope::ui
