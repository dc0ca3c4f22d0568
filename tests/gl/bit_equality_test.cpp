// bit_equality_test.cpp -- the shared source gives the same bits in C++ and on this GL, in compute shaders
// and fragment shaders.
#include <fmt/format.h>

#include <bit>
#include <limits>
#include <random>

#include "core/gl/buffer.hpp"
#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/render/moment_passes.hpp"
#include "tests/gl/gl_fixture.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

constexpr std::size_t COUNT = 262'144;  // 512 x 512

struct Item {  // shaders/tests/evaluate.glsl
    float b0, b[8], depth, view_depth, opacity, near_step, far_step;
};
struct Result {
    float absorbance, transmittance, warped, b0_with_fragment, b_with_fragment[8];
    float lower, upper, expected, spread;  // of the expected T in the pixel's own interval
    float near_with_fragment, far_with_fragment;
};
struct Header {
    float beta, theta, alpha, padding, z_min, z_max, more_padding[2];
};

constexpr float Z_MIN = 0.3f;
constexpr float Z_MAX = 40.0f;

ResolvedParameters in_own_interval(ResolvedParameters parameters) {
    parameters.estimation = {Estimate::expected, RayEnds::known, MomentInterval::pixel,
                             Renormalization::uncertain};
    return parameters;
}

// Half of the items have moments of the scene's interval, half of the pixel's own. Both functions are
// evaluated on both.
std::vector<Item> random_items(const Technique& technique, const ResolvedParameters& parameters) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<Item> items;
    while (items.size() < COUNT) {
        const ViewRay ray = random_ray(random);
        const MomentVector moments =
            sum_moments(ray, technique, items.size() < COUNT / 2 ? parameters : in_own_interval(parameters));
        std::vector<float> depths = own_depths(ray);
        depths.insert(depths.end(), {-1.0f, 1.0f, 2 * unit(random) - 1});
        for (const float depth : depths) {
            Item item{moments.b0,      {},
                      depth,           Z_MIN * std::pow(Z_MAX / Z_MIN, unit(random)),
                      unit(random),    moments.near_step,
                      moments.far_step};
            std::ranges::copy(moments.b, item.b);
            items.push_back(item);
        }
    }
    items.resize(COUNT);
    return items;
}

Result evaluate(const Technique& technique, const ResolvedParameters& p, const Item& item) {
    MomentVector moments{item.b0, {}, item.near_step, item.far_step};
    std::ranges::copy(item.b, moments.b.begin());
    Result result{};
    result.absorbance = technique.moment_kernel().steps(moments, settings_of(p), item.depth).absorbance;
    result.transmittance = transmittance(result.absorbance);
    result.warped = to_depth(item.view_depth, {DepthWarp::Kind::logarithmic, Z_MIN, Z_MAX});
    const float own = fragment_absorbance(item.opacity);
    FragmentEstimate estimate;
    technique.moment_kernel().estimates(moments, settings_of(in_own_interval(p)), {&item.depth, 1}, {&own, 1},
                                        {&estimate, 1});
    result.lower = estimate.lower;
    result.upper = estimate.upper;
    result.expected = estimate.transmittance;
    result.spread = estimate.spread;
    technique.moment_kernel().add_ends(moments, result.warped, own);
    result.near_with_fragment = moments.near_step;
    result.far_with_fragment = moments.far_step;
    technique.moment_kernel().add_fragment(moments, result.warped, own, settings_of(p));
    result.b0_with_fragment = moments.b0;
    std::ranges::copy(moments.b, result.b_with_fragment);
    return result;
}

class BitEquality : public GlTest<testing::TestWithParam<const Technique*>> {
protected:
    // Runs `draw` with the items bound and returns its output.
    template <typename Draw>
    std::vector<Result> run(const std::vector<Item>& items, const ResolvedParameters& p, Draw draw) {
        const Header header = {p.beta, basis_parameter(p, *GetParam()), p.alpha, 0, Z_MIN, Z_MAX, {}};
        const GlBuffer input = make_buffer(sizeof(Header) + items.size() * sizeof(Item));
        write_buffer(input, header);
        write_buffer(input, sizeof(Header), std::as_bytes(std::span(items)));
        std::vector<Result> results(items.size());
        const GlBuffer output = make_buffer_of<Result>(results);
        bind_storage(0, input);
        bind_storage(1, output);
        draw();
        finish_shader_writes();
        read_buffer(output, 0, std::as_writable_bytes(std::span(results)));
        return results;
    }

    void expect_same_bits(const std::vector<Result>& gl, const char* stage) {
        const ResolvedParameters p = resolve({}, *GetParam());
        long different[8] = {};  // absorbance, T, depth, b0, other moments, bounds, expected T, ends
        float worst = 0;
        long flushed = 0;
        for (std::size_t i = 0; i < COUNT; ++i) {
            const Result cpp = evaluate(*GetParam(), p, items_[i]);
            // Fragment shaders may flush denormal floats to 0, but C++ keeps them. Count these cases
            // separately.
            const auto differs = [&](float a, float b) {
                if (std::bit_cast<int>(a) == std::bit_cast<int>(b)) return 0;
                const bool tiny = std::abs(a) < std::numeric_limits<float>::min() && b == 0;
                flushed += tiny ? 1 : 0;
                return tiny ? 0 : 1;
            };
            different[0] += differs(cpp.absorbance, gl[i].absorbance);
            different[1] += differs(cpp.transmittance, gl[i].transmittance);
            different[2] += differs(cpp.warped, gl[i].warped);
            different[3] += differs(cpp.b0_with_fragment, gl[i].b0_with_fragment);
            for (int k = 0; k < GetParam()->moment_kernel().moment_floats; ++k)
                different[4] += differs(cpp.b_with_fragment[k], gl[i].b_with_fragment[k]);
            different[5] += differs(cpp.lower, gl[i].lower) + differs(cpp.upper, gl[i].upper);
            different[6] += differs(cpp.expected, gl[i].expected) + differs(cpp.spread, gl[i].spread);
            different[7] += differs(cpp.near_with_fragment, gl[i].near_with_fragment) +
                            differs(cpp.far_with_fragment, gl[i].far_with_fragment);
            worst = std::max(worst, std::abs(cpp.transmittance - gl[i].transmittance));
        }
        fmt::print(
            "{} {}: of {} differ: absorbance {}, transmittance {} (worst {}), depth {}, b0 {}, "
            "moments {}, bounds {}, expected T {}, ends {}; denormals flushed {}\n",
            GetParam()->id, stage, COUNT, different[0], different[1], worst, different[2], different[3],
            different[4], different[5], different[6], different[7], flushed);
        for (const long count : different) EXPECT_EQ(count, 0);
    }

    std::vector<Item> items_;
};

TEST_P(BitEquality, InComputeShaders) {
    if (!shared_programs()->gl().storage) GTEST_SKIP() << "this GL has no compute shaders";
    const ResolvedParameters p = resolve({}, *GetParam());
    items_ = random_items(*GetParam(), p);
    const GlProgram program = link_compute_program("tests/evaluate.comp", moment_variant(*GetParam()));
    expect_same_bits(run(items_, p,
                         [&] {
                             use_program(program);
                             glDispatchCompute(COUNT / 64, 1, 1);
                         }),
                     "compute");
}

TEST_P(BitEquality, InFragmentShaders) {
    if (!shared_programs()->gl().storage) GTEST_SKIP() << "this GL has no lists of results";
    const ResolvedParameters p = resolve({}, *GetParam());
    items_ = random_items(*GetParam(), p);
    const GlProgram program =
        link_program("passes/fullscreen.vert", "tests/evaluate.frag", moment_variant(*GetParam()));
    const GlTexture target = make_texture(GL_R8, {512, 512});
    const GlFramebuffer framebuffer = make_framebuffer({target}, 0);
    expect_same_bits(run(items_, p,
                         [&] {
                             set_draw_state({});
                             bind_framebuffer(framebuffer);
                             set_viewport({512, 512});
                             use_program(program);
                             draw_fullscreen();
                         }),
                     "fragment");
}

INSTANTIATE_TEST_SUITE_P(Techniques, BitEquality, testing::ValuesIn(kernel_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
