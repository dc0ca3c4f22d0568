#include "core/render/low_resolution_passes.hpp"

#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/low_footprint.hpp"

namespace momentscope {

namespace {

constexpr int SET_TEXELS = 2;  // for each of the two sets of moments
constexpr int TEXELS = 2 * SET_TEXELS;

}  // namespace

LowResolutionPasses::LowResolutionPasses(const Technique& technique, glm::ivec2 size, GLuint depth,
                                         const Capabilities& gl)
    : StatePasses(technique, size, depth, gl), full_depth_(depth) {}

void LowResolutionPasses::make_targets(int divisor) {
    const glm::ivec2 low_size = low_size_of(size_, divisor);
    if (low_size == low_size_) return;
    low_size_ = low_size;
    low_depth_ = {};
    depth_target_ = {};
    if (divisor > 1) {
        low_depth_ = make_texture(GL_DEPTH_COMPONENT32F, low_size);
        depth_target_ = make_framebuffer({}, low_depth_);
    }
    sums_.clear();
    converted_.clear();
    for (int i = 0; i < TEXELS; ++i) {
        sums_.push_back(make_texture(GL_RGBA32F, low_size));
        converted_.push_back(make_texture(GL_RGBA32F, low_size));
    }
    const GLuint depth = divisor > 1 ? low_depth_ : full_depth_;
    first_target_ = make_framebuffer({sums_[0], sums_[1]}, depth);
    second_target_ = make_framebuffer({sums_[2], sums_[3]}, depth);
    converted_target_ = make_framebuffer({converted_[0], converted_[1], converted_[2], converted_[3]}, 0);
}

void LowResolutionPasses::draw_low_depth(const PassInput& input) {
    set_draw_state({.depth = DepthTest::always});
    bind_framebuffer(depth_target_);
    const GLuint program = input.programs.get("passes/fullscreen.vert", "passes/farthest_depth.frag");
    use_program(program);
    set_uniform(program, "low_size", low_size_);
    bind_texture(0, full_depth_);
    draw_fullscreen();
}

void LowResolutionPasses::draw_set(const PassInput& input, bool second) {
    ShaderVariant variant = state_building_variant(technique_, settings_, OrderedAccess::none);
    variant.defines.erase("LOW_RESOLUTION");  // while states are built, they are read at their own pixel
    variant.defines["FIRST_TEXEL"] = second ? std::to_string(SET_TEXELS) : "0";
    variant.defines["WRITTEN_TEXELS"] = std::to_string(SET_TEXELS);
    if (second) {
        variant.defines["SECOND_PASS"] = "1";
        bind_states();
    }
    use_program(input.programs.get("passes/scene.vert", "passes/state.frag", variant));
    draw_transparent(input.scene, second ? second_target_ : first_target_, {.blending = Blending::add});
    convert(input);
}

void LowResolutionPasses::convert(const PassInput& input) {
    for (int i = 0; i < TEXELS; ++i)
        bind_texture(FIRST_STATE_UNIT + static_cast<GLuint>(i), sums_[static_cast<std::size_t>(i)]);
    set_draw_state({});
    bind_framebuffer(converted_target_);
    use_program(input.programs.get("passes/fullscreen.vert", "passes/state_convert.frag",
                                   state_variant(technique_, settings_)));
    draw_fullscreen();
}

void LowResolutionPasses::draw_moments(const PassInput& input) {
    settings_ = input.parameters.settings;
    make_targets(resolution_divisor(technique_, settings_));
    set_viewport(low_size_);
    if (low_depth_ != 0) draw_low_depth(input);
    clear_colors(first_target_, SET_TEXELS);
    clear_colors(second_target_, SET_TEXELS);
    draw_set(input, false);
    if (moment_sets(technique_, settings_) == 2) draw_set(input, true);
    set_viewport(size_);
}

std::optional<Transparency::LowTarget> LowResolutionPasses::low_target() const {
    if (low_depth_ == 0) return std::nullopt;
    return LowTarget{low_size_, low_depth_};
}

void LowResolutionPasses::bind_states() const {
    for (int i = 0; i < TEXELS; ++i)
        bind_texture(FIRST_STATE_UNIT + static_cast<GLuint>(i), converted_[static_cast<std::size_t>(i)]);
}

}  // namespace momentscope
