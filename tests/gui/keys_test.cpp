// keys_test.cpp -- every key of the key list does what the list says, with one test per key.
#include <fstream>
#include <map>
#include <set>

#include "tests/gui/gui_fixture.hpp"
#include "ui/commands/commands.hpp"

namespace momentscope::test {
namespace {

using ui::Series;

struct Pressed {
    ui::ExplorerState before;
    const ui::Workspace& now;
    glm::ivec2 pixel_before;
};
using Check = std::function<void(const Pressed&)>;

/// What must have changed afterwards, by command.
const std::map<std::string, Check>& checks() {
    const auto moved = [](glm::ivec2 by) {
        return [by](const Pressed& p) { EXPECT_EQ(p.now.measurement().pixel, p.pixel_before + by); };
    };
    const auto series = [](Series one) {
        return [one](const Pressed& p) {
            const auto i = static_cast<std::size_t>(one);
            EXPECT_NE(p.now.state.plot.shown[i], p.before.plot.shown[i]);
        };
    };
    const auto file = [](const Pressed& p) { EXPECT_TRUE(p.now.files.is_open()); };
    static std::map<std::string, Check> all = {
        {"file.open_session", file},
        {"file.save_session", file},
        {"file.open_mesh", file},
        {"file.open_ray", file},
        {"file.export", file},
        {"edit.undo",
         [](const Pressed& p) {
             EXPECT_NE(p.now.state, p.before);
             EXPECT_TRUE(p.now.history.can_redo());
         }},
        {"edit.redo",
         [](const Pressed& p) {
             EXPECT_FALSE(p.now.history.can_redo());
             EXPECT_NE(p.now.state, p.before);
         }},
        {"compare.next_failed",
         [](const Pressed& p) {
             EXPECT_TRUE(p.now.state.failures);
             EXPECT_EQ(p.now.status.message, "No pixel has failed.");
         }},
        {"try.next", [](const Pressed& p) { EXPECT_EQ(p.now.state.step, p.before.step + 1); }},
        {"try.previous", [](const Pressed& p) { EXPECT_EQ(p.now.state.step, p.before.step - 1); }},
        {"view.present", [](const Pressed& p) { EXPECT_TRUE(p.now.present); }},
        {"view.text_larger", [](const Pressed& p) { EXPECT_GT(p.now.settings.text_scale, 1); }},
        {"view.text_smaller", [](const Pressed& p) { EXPECT_LT(p.now.settings.text_scale, 1); }},
        {"view.text_standard", [](const Pressed& p) { EXPECT_EQ(p.now.settings.text_scale, 1); }},
        {"edit.reset_parameters",
         [](const Pressed& p) {
             EXPECT_NE(p.before.parameters, ParameterValues());
             EXPECT_EQ(p.now.state.parameters, ParameterValues());
         }},
        {"view.lens", [](const Pressed& p) { EXPECT_NE(p.now.state.lens, p.before.lens); }},
        {"view.lens_zoom", [](const Pressed& p) { EXPECT_EQ(p.now.state.lens_zoom, ui::LensZoom::digits); }},
        {"compare.take_reference",
         [](const Pressed& p) {
             EXPECT_EQ(p.now.state.compare.reference, p.before.technique);
             EXPECT_NE(p.before.compare.reference, p.before.technique);
         }},
        {"compare.wipe",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.compare.mode, ui::CompareMode::wipe); }},
        {"compare.difference",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.compare.mode, ui::CompareMode::difference); }},
        {"compare.false_color",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.compare.mode, ui::CompareMode::false_color); }},
        {"compare.uncertainty",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.compare.mode, ui::CompareMode::uncertainty); }},
        {"compare.swap",
         [](const Pressed& p) { EXPECT_NE(p.now.state.compare.swapped, p.before.compare.swapped); }},
        {"compare.next_worst",
         [](const Pressed& p) {
             EXPECT_NE(p.now.measurement().pixel, p.pixel_before);
             EXPECT_NE(p.now.status.message.find("Worst pixel 1"), std::string::npos) << p.now.status.message;
         }},
        {"view.failures", [](const Pressed& p) { EXPECT_NE(p.now.state.failures, p.before.failures); }},
        {"view.reset",
         [](const Pressed& p) {
             EXPECT_TRUE(p.before.camera);
             EXPECT_FALSE(p.now.state.camera);
         }},
        {"view.zoom_in",
         [](const Pressed& p) { EXPECT_LT(p.now.camera().distance, p.before.camera->distance); }},
        {"view.zoom_out",
         [](const Pressed& p) { EXPECT_GT(p.now.camera().distance, p.before.camera->distance); }},
        {"edit.delete_fragment",
         [](const Pressed& p) {
             EXPECT_EQ(p.now.state.ray->fragments.size() + 1, p.before.ray->fragments.size());
         }},
        {"view.theme", [](const Pressed& p) { EXPECT_NE(p.now.state.theme, p.before.theme); }},
        {"pixel.left", moved({-1, 0})},
        {"pixel.right", moved({1, 0})},
        {"pixel.up", moved({0, -1})},
        {"pixel.down", moved({0, 1})},
        {"pixel.left10", moved({-10, 0})},
        {"pixel.right10", moved({10, 0})},
        {"pixel.up10", moved({0, -10})},
        {"pixel.down10", moved({0, 10})},
        {"pixel.go_to", [](const Pressed&) { EXPECT_TRUE(ImGui::GetIO().WantTextInput); }},
        {"pixel.pin", [](const Pressed& p) { EXPECT_EQ(p.now.state.pins.size(), p.before.pins.size() + 1); }},
        {"pixel.unpin_all",
         [](const Pressed& p) {
             EXPECT_FALSE(p.before.pins.empty());
             EXPECT_TRUE(p.now.state.pins.empty());
         }},
        {"pixel.next_fragment",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.marked, p.now.measurement().history[1].fragment); }},
        {"pixel.previous_fragment",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.marked, p.now.measurement().history[0].fragment); }},
        {"plot.fit",
         [](const Pressed& p) {
             EXPECT_TRUE(p.before.plot.depth);
             EXPECT_FALSE(p.now.state.plot.depth);
         }},
        {"plot.quantity",
         [](const Pressed& p) { EXPECT_EQ(p.now.state.plot.quantity, ui::Quantity::transmittance); }},
        {"plot.axis", [](const Pressed& p) { EXPECT_EQ(p.now.state.plot.axis, ui::DepthAxis::view); }},
        {"plot.light",
         [](const Pressed& p) {
             EXPECT_EQ(p.now.state.viewpoint, ui::Viewpoint::transparent_casters);
             EXPECT_TRUE(p.now.measurement().light.has_value());
         }},
        {"plot.truth", series(Series::truth)},
        {"plot.reconstruction", series(Series::reconstruction)},
        {"plot.bounds", series(Series::bounds)},
        {"plot.sharp", series(Series::sharp)},
        {"plot.ghost", series(Series::unbiased_exact)},
        {"plot.stems", series(Series::stems)},
        {"plot.errors", series(Series::errors)},
        {"plot.wrapping_zone", series(Series::wrapping_zone)},
        {"help.keys", [](const Pressed& p) { EXPECT_TRUE(p.now.help); }},
        {"help.palette", [](const Pressed& p) { EXPECT_TRUE(p.now.palette.open); }},
        {"help.close",
         [](const Pressed& p) {
             EXPECT_FALSE(p.before.card.empty());
             EXPECT_TRUE(p.now.state.card.empty());
         }},
    };
    for (std::size_t i = 0; i < ui::PANELS.size(); ++i)
        all[fmt::format("view.panel{}", i + 1)] = [i](const Pressed& p) {
            EXPECT_EQ(p.now.state.panel, ui::PANELS[i].id);
        };
    return all;
}

struct KeyCase {
    std::string command, key;
};

std::vector<KeyCase> key_cases() {
    std::vector<KeyCase> cases;
    for (const ui::Command& command : ui::commands())
        for (const std::string& key : command.keys) cases.push_back({command.id, key});
    return cases;
}

class KeyTest : public GuiTest, public testing::WithParamInterface<KeyCase> {
protected:
    /// A state in which every key has an effect.
    void open_with_something_of_everything() {
        ui::ExplorerState first;
        first.scene = "planes";
        first.technique = &require_technique("trig2-32");
        first.picked = glm::vec2(0.5f, 0.5f);
        open(first);
        ui::ExplorerState& state = workspace().state;
        state.camera = workspace().camera();
        state.camera->azimuth = 0.1f;
        state.parameters.set(ParameterId::beta, 0.75f);
        state.plot.depth = ui::Range{-0.5f, 0.5f};
        state.pins = {glm::vec2(0.3f, 0.5f)};
        state.card = "order";
        settle();
        state.marked = measurement().history[0].fragment;
        settle();
    }
};

TEST_P(KeyTest, DoesWhatTheListSays) {
    const auto& [id, key] = GetParam();
    open_with_something_of_everything();
    if (id == "try.previous") play("key PageDown");
    if (id == "view.text_standard") play("key Ctrl+Plus");
    if (id == "edit.redo") play("key Ctrl+Z");
    if (id == "view.lens_zoom") play("key L");
    if (id == "compare.swap") play("key W");
    if (id == "pixel.previous_fragment") play("key N");
    if (id == "view.panel1") play("key Ctrl+2");
    if (id == "edit.delete_fragment") {
        play("click @tab.5\nclick @editor.detach");
        workspace().state.marked = 1;
        settle();
    }
    if (id == "view.fullscreen") {
        int toggled = 0;
        workspace().options.host.toggle_fullscreen = [&] { ++toggled; };
        play("key " + key);
        EXPECT_EQ(toggled, 1);
        return;
    }
    const Pressed pressed = {state(), workspace(), measurement().pixel};
    if (id == "compare.flip") {
        play("hold " + key);
        EXPECT_TRUE(workspace().comparison.flipped());
        play("let " + key);
        EXPECT_FALSE(workspace().comparison.flipped());
        return;
    }
    play("key " + key);
    if (id.starts_with("technique.")) {
        EXPECT_EQ("technique." + std::string(state().technique->id), id);
        return;
    }
    const auto check = checks().find(id);
    ASSERT_NE(check, checks().end()) << "no test for the key " << key << " of " << id;
    check->second(pressed);
}

INSTANTIATE_TEST_SUITE_P(Keys, KeyTest, testing::ValuesIn(key_cases()), [](const auto& test) {
    std::string name = test.param.command + "_" + std::to_string(test.index);
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
});

TEST(Commands, HaveUniqueIdsAndKeys) {
    std::set<std::string> ids, keys;
    for (const ui::Command& command : ui::commands()) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id;
        EXPECT_FALSE(command.name.empty() || command.help.empty()) << command.id;
        for (const std::string& key : command.keys) {
            EXPECT_TRUE(ui::parse_shortcut(key)) << key;
            EXPECT_TRUE(keys.insert(key).second) << key << " has two meanings";
        }
    }
}

// docs/guide lists the keys; this is the row that it must contain.
TEST(Commands, StandInTheGuideWithTheirKeys) {
    std::ifstream file("docs/guide/README.md");
    const std::string guide((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const ui::Command& command : ui::commands()) {
        if (command.keys.empty()) continue;
        const std::string row =
            fmt::format("| `{}` | {}: {} |", fmt::join(command.keys, "`, `"), command.name, command.help);
        EXPECT_NE(guide.find(row), std::string::npos) << row;
    }
    for (const ui::MouseAction& action : ui::mouse_actions())
        EXPECT_NE(guide.find(fmt::format("| {} on {} | {} |", action.how, action.where, action.what)),
                  std::string::npos)
            << action.how << " on " << action.where << " | " << action.what;
}

class TypingTest : public GuiTest {};

TEST_F(TypingTest, LettersTypedIntoAFieldAreNoShortcuts) {
    open();
    const ui::ExplorerState before = state();
    play("key Ctrl+G\nkey L\nkey P\nkey O\nkey T\nkey 1\nkey Escape");
    EXPECT_EQ(state(), before);
}

TEST_F(TypingTest, ThePaletteFindsAndRunsACommand) {
    open();
    play("key Ctrl+Shift+P\ntype lens\nkey Enter");
    EXPECT_TRUE(state().lens);
    EXPECT_FALSE(workspace().palette.open);
    play("key Ctrl+Shift+P\ntype zzz\nkey Enter\nkey Escape");
    EXPECT_FALSE(workspace().palette.open);
    play("key Ctrl+Shift+P\ntype scene spheres\nclick @palette.scene.spheres");
    EXPECT_EQ(state().scene, "spheres");
}

TEST_F(TypingTest, NumbersAreTypedIntoParameters) {
    open("planes", "trig2-32");
    const auto type = [&](const std::string& key, const std::string& text) {
        play(fmt::format("hold Ctrl\nclick @parameter.{}\nlet Ctrl\ntype {}\nkey Enter", key, text));
    };
    type("beta", "0.625");
    EXPECT_EQ(state().parameters[ParameterId::beta], std::optional(0.625f));
    type("alpha", "1e-4");
    EXPECT_EQ(state().parameters[ParameterId::alpha], std::optional(1e-4f));
    type("alpha", "auto");
    EXPECT_EQ(state().parameters[ParameterId::alpha], std::nullopt);
    for (const char* nonsense : {"7", "-1", "nan", "inf", "0.5x", "1,5", "β", "1e999"}) {
        type("beta", nonsense);
        EXPECT_EQ(state().parameters[ParameterId::beta], std::optional(0.625f)) << nonsense;
        EXPECT_FALSE(message().empty()) << nonsense;
    }
    play("doubleclick @parameter.beta");
    EXPECT_EQ(state().parameters[ParameterId::beta], ParameterValues()[ParameterId::beta]) << "reset";
}

TEST_F(TypingTest, ParametersAreTypedFromTheKeyboardAlone) {
    open();
    play("key Ctrl+Shift+P\ntype type overestimation\nkey Enter\ntype 0.875\nkey Enter");
    EXPECT_EQ(state().parameters[ParameterId::beta], std::optional(0.875f)) << message();
}

}  // namespace
}  // namespace momentscope::test
