#include "core/gl/rounding_check.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/vertex_array.hpp"

namespace momentscope {

namespace {

// The errors are exact in double: a sum of floats within 2^29 of each other, and any product of floats.
glm::vec4 exact(float a, float b) {
    const float sum = a + b, product = a * b;
    return {
        sum, static_cast<float>(static_cast<double>(a) + static_cast<double>(b) - static_cast<double>(sum)),
        product,
        static_cast<float>(static_cast<double>(a) * static_cast<double>(b) - static_cast<double>(product))};
}

// Each operation is rounded.
glm::vec4 with_constants(float a, float b) {
    const float shifted = (a - 1.57079637f) + 4.37113883e-8f;
    const float scaled = (b * 3.14159274f) * 1.44269502f;
    const float polynomial = a * (-0.5f + a * (4.16666679e-2f + a * -1.38888892e-3f));
    return {shifted, scaled, polynomial, 1.0f};
}

int bits_of(float x) {
    return std::bit_cast<std::int32_t>(x);
}

}  // namespace

bool keeps_rounding_errors(ShaderLanguage language) {
    constexpr glm::vec2 PAIRS[] = {
        {1.0f, 3.0000001e-5f}, {0.7182818f, -0.31415927f}, {-1234.5678f, 0.0098765432f}};
    const GlProgram program =
        link_program("passes/fullscreen.vert", "passes/rounding_check.frag", {}, language);
    const GlTexture texels = make_texture(GL_RGBA32F, {2, 1});
    const GlFramebuffer target = make_framebuffer({texels}, 0);
    const auto drawn = [&](glm::vec2 pair) {
        set_draw_state({});
        set_viewport({2, 1});
        bind_framebuffer(target);
        use_program(program);
        set_uniform(program, "first_bits", bits_of(pair.x));
        set_uniform(program, "second_bits", bits_of(pair.y));
        draw_fullscreen();
        return read_colors(texels, {{0, 0}, {2, 1}});
    };
    const bool kept = std::ranges::all_of(PAIRS, [&](glm::vec2 pair) {
        return drawn(pair) == std::vector{exact(pair.x, pair.y), with_constants(pair.x, pair.y)};
    });
    use_program(0);
    bind_framebuffer(0);
    return kept;
}

Rounding kept_rounding(Dialect dialect) {
    for (const Rounding rounding : {language_of(dialect).rounding, Rounding::guarded})
        if (keeps_rounding_errors({dialect, rounding})) return rounding;
    return Rounding::lost;
}

}  // namespace momentscope
