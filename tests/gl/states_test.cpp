// states_test.cpp -- pictures of all techniques against the same pixels composed in C++ from their fragments.
#include <fmt/format.h>

#include <algorithm>

#include "core/inspect/method_pixel.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/inspect/pixel_history.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 SIZE(160, 90);
constexpr std::size_t PIXELS = 200;

std::vector<const Technique*> method_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.method != nullptr) rows.push_back(&row);
    return rows;
}

ParameterValues with(std::initializer_list<std::pair<ParameterId, float>> settings) {
    ParameterValues values;
    for (const auto& [id, value] : settings) values.set(id, value);
    return values;
}

// All at their standard, every other value of one parameter at a time (of many, each the double of the one
// before), and what Moment Transparency makes of several.
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
        all.push_back(with({{resolution, 2}, {read_format, 1}}));
        all.push_back(with({{resolution, 1}, {moment_passes, 1}, {order, 1}}));
        all.push_back(with({{resolution, 3}, {read_format, 1}, {moment_passes, 2}}));
        all.push_back(with({{read_format, 3}, {moment_passes, 1}}));
        all.push_back(with({{read_format, 2}, {depth_range, 1}}));
    }
    if (technique.order_dependent) {
        all.push_back(with({{ParameterId::order, 1}}));
        all.push_back(with({{ParameterId::order, 2}, {ParameterId::order_seed, 3}}));
    }
    return all;
}

Scene opaque_part(Scene scene) {
    std::erase_if(scene.objects, [](const Object& object) { return !object.opaque(); });
    return scene;
}

class StatesTest : public GlTest<::testing::TestWithParam<const Technique*>> {};

TEST_P(StatesTest, EveryPixelIsWhatCppComposes) {
    const Technique& technique = *GetParam();
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer renderer, opaque;
        renderer.set_scene(scene);
        opaque.set_scene(opaque_part(scene));
        opaque.render(view_of(scene, "sorted", SIZE));
        const Image behind = opaque.read_picture();
        View view = view_of(scene, technique.id, SIZE);
        if (const std::string why = why_unavailable(technique, renderer.ordered_access()); !why.empty())
            GTEST_SKIP() << why;
        for (const ParameterValues& values : choices_of(technique)) {
            view.parameters = values;
            renderer.render(view);
            const Image picture = renderer.read_picture();
            const auto captures = renderer.capture_region({0, 0}, SIZE);
            std::vector<std::size_t> covered;
            for (std::size_t i = 0; i < captures.size(); ++i)
                if (!captures[i].ray.fragments.empty()) covered.push_back(i);
            ASSERT_FALSE(covered.empty());
            const ResolvedParameters parameters = resolve(values, technique);
            // Eight bits: a product that rounds the other way is 1/255, and is merged into what follows.
            const bool coarse = technique.uses(ParameterId::layer_bits) && parameters.method.option == 1;
            const float tolerance = coarse ? 8e-3f : 2e-4f;
            const std::size_t step = std::max<std::size_t>(covered.size() / PIXELS, 1);
            int off = 0;
            float worst = 0;
            for (std::size_t k = 0; k < covered.size(); k += step) {
                const PixelCapture& capture = captures[covered[k]];
                const int x = static_cast<int>(covered[k]) % SIZE.x,
                          y = static_cast<int>(covered[k]) / SIZE.x;
                const glm::vec3 expected =
                    method_color(capture.ray, technique, parameters, glm::vec3(behind.at(x, y)));
                const glm::vec3 apart = glm::abs(glm::vec3(picture.at(x, y)) - expected);
                const float most = std::max({apart.r, apart.g, apart.b});
                worst = std::max(worst, most);
                off += most > tolerance ? 1 : 0;
                if (technique.method->has_depths()) {
                    const auto rows = pixel_history(capture.ray, capture.transmittance, technique, values);
                    for (const PixelHistoryRow& row : rows) {
                        EXPECT_NEAR(*row.gl_transmittance, row.transmittance,
                                    tolerance * std::max(row.transmittance, 1.0f));
                    }
                }
            }
            EXPECT_EQ(off, 0) << technique.id << " on " << entry.id << ", worst " << worst;
        }
    }
}

std::vector<const Technique*> other_techniques() {
    std::vector<const Technique*> rows = moment_based_techniques();
    rows.push_back(&require_technique("sorted"));
    return rows;
}

class WithMomentsTest : public GlTest<::testing::TestWithParam<const Technique*>> {};

// Thirty fragments, each of which rounds a sum of at most 1 to half a unit of 11 bits.
constexpr float HALVES = 7e-3f;

// The GL sums weighted colours in half floats, as the paper's evaluation does, and C++ in floats.
TEST_P(WithMomentsTest, EveryPixelIsWhatCppComposes) {
    const Technique& technique = *GetParam();
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = load_scene(entry.id, 0.4f);
        Renderer renderer;
        renderer.set_scene(scene);
        const View view = view_of(scene, technique.id, SIZE);
        if (const std::string why = why_unavailable(technique, renderer.ordered_access()); !why.empty())
            GTEST_SKIP() << why;
        renderer.render(view);
        const Image picture = renderer.read_picture();
        const auto captures = renderer.capture_region({0, 0}, SIZE);
        std::vector<std::size_t> covered;
        for (std::size_t i = 0; i < captures.size(); ++i)
            if (!captures[i].ray.fragments.empty()) covered.push_back(i);
        const std::size_t step = std::max<std::size_t>(covered.size() / PIXELS, 1);
        for (std::size_t k = 0; k < covered.size(); k += step) {
            const PixelCapture& capture = captures[covered[k]];
            const auto rows = pixel_history(capture.ray, {}, technique, view.parameters);
            const PixelColors colors = pixel_colors(capture.ray, rows, technique,
                                                    resolve(view.parameters, technique), capture.behind);
            const glm::vec3 shown(
                picture.at(static_cast<int>(covered[k]) % SIZE.x, static_cast<int>(covered[k]) / SIZE.x));
            const glm::vec3 expected = technique.is_truth() ? colors.truth : colors.technique;
            const glm::vec3 apart = glm::abs(shown - expected);
            EXPECT_LT(std::max({apart.r, apart.g, apart.b}), technique.is_truth() ? 2e-4f : HALVES)
                << technique.id << " on " << entry.id;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, WithMomentsTest, ::testing::ValuesIn(other_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

INSTANTIATE_TEST_SUITE_P(Techniques, StatesTest, ::testing::ValuesIn(method_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

}  // namespace
}  // namespace momentscope::test
