// states_test.cpp -- compares pictures of all techniques with the same pixels, composited in C++ from their
// fragments.
#include <fmt/format.h>

#include <algorithm>

#include "core/inspect/pixel_color.hpp"
#include "core/inspect/pixel_history.hpp"
#include "core/inspect/pixel_state_curve.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 STATES_SIZE(160, 90);
constexpr std::size_t PIXELS = 200;

std::vector<const Technique*> pixel_state_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.has_pixel_states()) rows.push_back(&row);
    return rows;
}

// All parameters at their defaults; one parameter at each of its values (at powers of two in long ranges);
// some combinations for Moment Transparency; other orders of submission.
std::vector<ParameterValues> choices_of(const Technique& technique) {
    std::vector<ParameterValues> all = {{}};
    for (const ParameterId id : technique.parameters) {
        const Parameter& row = parameter(id);
        const bool many = row.maximum - row.minimum > 10;
        for (float value = row.minimum; value <= row.maximum; value = many ? 2 * value : value + 1) {
            all.emplace_back();
            all.back().set(id, value);
        }
    }
    if (technique.uses(ParameterId::resolution)) {
        using enum ParameterId;
        all.push_back(values_with({{resolution, 2}, {read_format, 1}}));
        all.push_back(values_with({{resolution, 1}, {moment_passes, 1}, {order, 1}}));
        all.push_back(values_with({{resolution, 3}, {read_format, 1}, {moment_passes, 2}}));
        all.push_back(values_with({{read_format, 3}, {moment_passes, 1}}));
        all.push_back(values_with({{read_format, 2}, {depth_range, 1}}));
    }
    if (technique.order_dependent) {
        all.push_back(values_with({{ParameterId::order, 1}}));
        all.push_back(values_with({{ParameterId::order, 2}, {ParameterId::order_seed, 3}}));
    }
    std::erase_if(all,
                  [&](const ParameterValues& values) { return why_refused(technique, values) != nullptr; });
    return all;
}

Scene opaque_part(Scene scene) {
    std::erase_if(scene.objects, [](const Object& object) { return !object.opaque(); });
    return scene;
}

struct Covered {
    glm::vec3 shown;
    const PixelCapture& capture;
};

// About PIXELS pixels with a transparent fragment, evenly distributed over the picture.
std::vector<Covered> some_covered(const Image& picture, const std::vector<PixelCapture>& captures) {
    std::vector<Covered> covered;
    for (std::size_t i = 0; i < captures.size(); ++i)
        if (!captures[i].ray.fragments.empty())
            covered.push_back({glm::vec3(picture.pixels[i]), captures[i]});
    const std::size_t step = std::max<std::size_t>(covered.size() / PIXELS, 1);
    std::vector<Covered> some;
    for (std::size_t k = 0; k < covered.size(); k += step) some.push_back(covered[k]);
    EXPECT_FALSE(some.empty());
    return some;
}

float distance_between(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 apart = glm::abs(a - b);
    return std::max({apart.r, apart.g, apart.b});
}

class StatesTest : public GlTest<::testing::TestWithParam<const Technique*>> {};

// In eight bits, a product that is rounded the other way is off by 1/255 and is merged into the following
// ones.
float tolerance_of(const Technique& technique, const ParameterValues& values) {
    const bool layers = technique.uses(ParameterId::layer_bits);
    return layers && values.get<LayerBits>() == LayerBits::bits_8 ? 8e-3f : 2e-4f;
}

void expect_composed(const Technique& technique, const ParameterValues& values,
                     const std::vector<Covered>& pixels, const std::string& scene) {
    const ResolvedParameters parameters = resolve(values, technique);
    const float tolerance = tolerance_of(technique, values);
    float worst = 0;
    for (const auto& [shown, capture] : pixels) {
        worst = std::max(worst, distance_between(shown, pixel_state_color(capture.ray, technique, parameters,
                                                                          capture.behind)));
        if (!technique.pixel_state_kernel().has_depths()) continue;
        for (const PixelHistoryRow& row :
             pixel_history(capture.ray, capture.transmittance, technique, values))
            EXPECT_NEAR(*row.gl_transmittance, row.transmittance,
                        tolerance * std::max(row.transmittance, 1.0f));
    }
    EXPECT_LE(worst, tolerance) << technique.id << " on " << scene;
}

// Scenes with ties, with intersections and with many fragments.
bool has_every_choice(std::string_view scene) {
    return scene == "ties" || scene == "spheres" || scene == "smoke";
}

// With all choices of parameters on some scenes, and with the defaults on the others.
TEST_P(StatesTest, EveryPixelIsWhatCppComposes) {
    const Technique& technique = *GetParam();
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        View view = view_of(scene, technique.id, STATES_SIZE);
        if (const std::string why = why_unavailable(technique, renderer.gl()); !why.empty())
            GTEST_SKIP() << why;
        const std::vector<ParameterValues> choices =
            has_every_choice(entry.id) ? choices_of(technique) : std::vector(1, ParameterValues());
        for (const ParameterValues& values : choices) {
            view.parameters = values;
            renderer.render(view);
            const auto captures = renderer.capture_region({0, 0}, STATES_SIZE);
            expect_composed(technique, values, some_covered(renderer.read_picture(), captures), entry.id);
        }
    }
}

// The captured background equals the picture without transparent surfaces.
TEST(CapturesTest, KnowWhatLiesBehind) {
    shared_context();
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer renderer(shared_programs()), opaque(shared_programs());
        renderer.set_scene(scene);
        renderer.render(view_of(scene, "unsorted", STATES_SIZE));
        opaque.set_scene(opaque_part(scene));
        opaque.render(view_of(scene, "sorted", STATES_SIZE));
        const auto captures = renderer.capture_region({0, 0}, STATES_SIZE);
        const Image behind = opaque.read_picture();
        for (std::size_t i = 0; i < captures.size(); ++i)
            ASSERT_EQ(captures[i].behind, glm::vec3(behind.pixels[i])) << entry.id << ", pixel " << i;
    }
}

std::vector<const Technique*> other_techniques() {
    std::vector<const Technique*> rows = moment_based_techniques();
    rows.push_back(&require_technique("sorted"));
    return rows;
}

class WithMomentsTest : public GlTest<::testing::TestWithParam<const Technique*>> {};

// Thirty fragments; each rounds a sum of at most 1 to half a unit of 11 bits.
constexpr float HALVES = 7e-3f;

// The GL sums weighted colours in half floats, as in the paper's evaluation, and C++ in floats.
TEST_P(WithMomentsTest, EveryPixelIsWhatCppComposes) {
    const Technique& technique = *GetParam();
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        const View view = view_of(scene, technique.id, STATES_SIZE);
        if (const std::string why = why_unavailable(technique, renderer.gl()); !why.empty())
            GTEST_SKIP() << why;
        renderer.render(view);
        const auto captures = renderer.capture_region({0, 0}, STATES_SIZE);
        float worst = 0;
        for (const auto& [shown, capture] : some_covered(renderer.read_picture(), captures)) {
            const auto rows = pixel_history(capture.ray, {}, technique, view.parameters);
            const PixelColors colors = pixel_colors(capture.ray, rows, technique,
                                                    resolve(view.parameters, technique), capture.behind);
            worst = std::max(worst,
                             distance_between(shown, technique.is_truth() ? colors.truth : colors.technique));
        }
        EXPECT_LE(worst, technique.is_truth() ? 2e-4f : HALVES) << technique.id << " on " << entry.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, WithMomentsTest, ::testing::ValuesIn(other_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

INSTANTIATE_TEST_SUITE_P(Techniques, StatesTest, ::testing::ValuesIn(pixel_state_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

}  // namespace
}  // namespace momentscope::test
