// storage_test.cpp -- the textures of the first pass hold the sums that C++ computes, and a GL without the
// necessary features is refused with a sentence.
#include <fmt/format.h>

#include <cmath>

#include "core/techniques/moment_kernel.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

class Storage : public GlTest<testing::TestWithParam<const Technique*>> {
protected:
    // The number of stored numbers that differ from those of C++, over every pixel of the teapots.
    void compare(const ParameterValues& values) {
        const Technique& technique = *GetParam();
        const Scene scene = load_scene("teapots", 0.4f);
        const glm::ivec2 size(320, 180);
        Renderer renderer(shared_programs());
        renderer.set_scene(scene);
        View view = view_of(scene, technique.id, size);
        view.parameters = values;
        renderer.render(view);
        long numbers = 0;
        long different = 0;
        long pixels = 0;
        for (const PixelCapture& capture : renderer.capture_region({0, 0}, size)) {
            if (capture.ray.fragments.empty()) continue;
            ASSERT_TRUE(capture.stored.has_value());
            const MomentVector cpp = sum_moments(capture.ray, technique, resolve(values, technique));
            different += capture.stored->b0 != cpp.b0 ? 1 : 0;
            ++numbers;
            for (std::size_t k = 0; k < static_cast<std::size_t>(technique.moment_kernel().moment_floats);
                 ++k) {
                float gl = capture.stored->b[k];
                float own = cpp.b[k];
                // A texture unit may be off by an ulp in code / 65535; the shaders round this away.
                if (technique.moment_kernel().bits == 16)
                    gl = std::round(gl * 65535.0f), own = std::round(own * 65535.0f);
                different += gl == own ? 0 : 1;
                ++numbers;
            }
            different += capture.stored->near_step != cpp.near_step ? 1 : 0;
            different += capture.stored->far_step != cpp.far_step ? 1 : 0;
            ++pixels;
        }
        fmt::print("{}: {} of {} numbers in {} pixels differ\n", technique.id, different, numbers, pixels);
        EXPECT_EQ(different, 0);
        EXPECT_GT(pixels, 30'000);
    }
};

TEST_P(Storage, HoldsTheBitsOfCpp) {
    if (const std::string why = why_unavailable(*GetParam(), shared_programs()->gl()); !why.empty())
        GTEST_SKIP() << why;
    compare({});
}

// Techniques that can sum by blending or in order: those with floats.
std::vector<const Technique*> ordered_or_not() {
    std::vector<const Technique*> rows = moment_based_techniques();
    std::erase_if(rows, [](const Technique* row) { return !row->uses(ParameterId::accumulation); });
    return rows;
}
class OrderedStorage : public Storage {};

TEST_P(OrderedStorage, HoldsTheBitsOfCpp) {
    if (shared_programs()->gl().ordered == OrderedAccess::none) GTEST_SKIP() << "this GL keeps no order";
    ParameterValues values;
    values.set(MomentAccumulation::ordered);
    compare(values);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Storage, testing::ValuesIn(moment_based_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

INSTANTIATE_TEST_SUITE_P(Techniques, OrderedStorage, testing::ValuesIn(ordered_or_not()),
                         [](const auto& row) { return test_name(*row.param); });

class WithoutOrder : public GlTest<> {};

Capabilities gl_with(OrderedAccess access) {
    Capabilities gl;
    gl.ordered = access;
    gl.storage = gl.unorm16 = true;
    return gl;
}

TEST_F(WithoutOrder, SixteenBitsSayWhyAndTheLastPictureStays) {
    const Scene scene = load_scene("planes", 0.4f);
    Capabilities gl = capabilities();
    gl.ordered = OrderedAccess::none;
    Renderer renderer(std::make_shared<ProgramCache>(gl));
    renderer.set_scene(scene);
    renderer.render(view_of(scene, "power4-32", {32, 18}));
    try {
        renderer.render(view_of(scene, "power4-16", {32, 18}));
        ADD_FAILURE() << "drawn without ordered access";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("GL_ARB_fragment_shader_interlock"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("32 bits"), std::string::npos) << "what to do";
    }
    View ordered = view_of(scene, "power4-32", {32, 18});
    ordered.parameters.set(MomentAccumulation::ordered);
    EXPECT_THROW(renderer.render(ordered), Error);
    EXPECT_NO_THROW(renderer.render(view_of(scene, "power4-32", {32, 18})));
}

TEST_F(WithoutOrder, AvailabilityFollowsTheAccess) {
    for (const Technique& technique : techniques()) {
        EXPECT_EQ(why_unavailable(technique, gl_with(OrderedAccess::interlock)), "");
        EXPECT_EQ(why_unavailable(technique, gl_with(OrderedAccess::framebuffer_fetch)), "");
        const bool sixteen = technique.has_moments() && technique.moment_kernel().bits == 16;
        const bool changes_nodes = technique.id == std::string("at") || technique.id == std::string("mlab");
        EXPECT_EQ(why_unavailable(technique, gl_with(OrderedAccess::none)).empty(),
                  !sixteen && !changes_nodes)
            << technique.id;
    }
}

}  // namespace
}  // namespace momentscope::test
