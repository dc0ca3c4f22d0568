// every_technique_test.cpp -- every technique draws every scene, with every value of its parameters, without
// a GL error and without infinite or NaN pixels.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/effort.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

// Such failures do not need a large picture.
const glm::ivec2 PICTURE_SIZE = effort(1, 4) * glm::ivec2(160, 90);

std::vector<const Technique*> all_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques()) rows.push_back(&row);
    return rows;
}

// Every choice of a parameter; for a range, the ends and two values between.
std::vector<ParameterValues> few_choices_of(const Technique& technique) {
    std::vector<ParameterValues> all;
    for (const ParameterId id : technique.parameters) {
        // One technique of each basis stands for all of them.
        const bool of_estimate = id == ParameterId::estimate || id == ParameterId::ends;
        if (of_estimate && technique.moments().moment_count != 4) continue;
        const Parameter& row = parameter(id);
        const bool few = row.scale == Scale::choice || row.scale == Scale::toggle;
        const int steps = few ? static_cast<int>(row.maximum - row.minimum) : 3;
        for (int i = 0; i <= steps; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(steps);
            const float value = i == steps ? row.maximum : row.minimum + share * (row.maximum - row.minimum);
            all.emplace_back();
            all.back().set(id, row.scale == Scale::linear || row.scale == Scale::logarithmic
                                   ? value
                                   : std::round(value));
        }
    }
    std::erase_if(all,
                  [&](const ParameterValues& values) { return why_refused(technique, values) != nullptr; });
    return all;
}

class EveryTechniqueTest : public GlTest<::testing::TestWithParam<const Technique*>> {
protected:
    static void expect_picture(Renderer& renderer, const View& view, const std::string& scene) {
        renderer.render(view);  // throws if GL fails
        const Image picture = renderer.read_picture();
        long bad = 0;
        float least = 1e9f, most = 0;
        for (const glm::vec4& pixel : picture.pixels) {
            bad += std::isfinite(pixel.r + pixel.g + pixel.b) ? 0 : 1;
            least = std::min(least, pixel.g);
            most = std::max(most, pixel.g);
        }
        EXPECT_EQ(bad, 0) << view.technique->id << " on " << scene;
        EXPECT_GT(most - least, 0.05f) << view.technique->id << " on " << scene << " shows nothing";
    }
};

TEST_P(EveryTechniqueTest, DrawsEveryScene) {
    const Technique& technique = *GetParam();
    Renderer renderer(shared_programs());
    if (const std::string why = why_unavailable(technique, renderer.gl()); !why.empty()) GTEST_SKIP() << why;
    std::vector<ParameterValues> choices = few_choices_of(technique);
    if (renderer.gl().ordered == OrderedAccess::none)
        std::erase_if(choices, [&](const auto& values) { return resolve(values, technique).ordered; });
    std::size_t next = 0;
    const std::size_t scenes = scene_entries().size();
    for (std::size_t i = 0; i < scenes; ++i) {
        const SceneEntry& entry = scene_entries()[i];
        const Scene scene = load_scene(entry.id, 0.4f);
        renderer.set_scene(scene);
        expect_picture(renderer, view_of(scene, technique.id, PICTURE_SIZE), entry.id);
        // The scenes take turns with the choices; states_test.cpp draws each choice on every scene at a small
        // size.
        for (const std::size_t end = choices.size() * (i + 1) / scenes; next < end; ++next) {
            View view = view_of(scene, technique.id, PICTURE_SIZE);
            view.parameters = choices[next];
            expect_picture(renderer, view, entry.id);
        }
    }
    const std::vector<std::string> notes = shared_programs()->take_notes();
    EXPECT_TRUE(notes.empty()) << notes.front();  // all loops of shaders are written out
}

INSTANTIATE_TEST_SUITE_P(Techniques, EveryTechniqueTest, ::testing::ValuesIn(all_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

using Refusals = GlTest<>;

TEST_F(Refusals, NonlinearMomentsAtLowResolution) {
    Renderer renderer(shared_programs());
    const Scene scene = load_scene("planes", 0.4f);
    renderer.set_scene(scene);
    View view = view_of(scene, "mt", {32, 18});
    view.parameters.set(MomentResolution::quarter);
    view.parameters.set(ReadFormat::nlqm32);
    EXPECT_THROW(renderer.render(view), Error);
    view.parameters.set(ReadFormat::theta16);
    EXPECT_NO_THROW(renderer.render(view));
}

}  // namespace
}  // namespace momentscope::test
