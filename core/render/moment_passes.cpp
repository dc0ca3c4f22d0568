#include "core/render/moment_passes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/gl/buffer.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/quantisation_glsl.hpp"

namespace momentscope {

namespace {

constexpr const char* SCENE = "passes/scene.vert";
constexpr const char* MOMENTS = "passes/moments.frag";
constexpr const char* ENDS = "passes/ends.frag";
constexpr const char* FACTOR = "passes/factor.frag";
constexpr const char* COLOR = "passes/color.frag";
constexpr const char* FAILURES = "passes/failures.frag";
constexpr const char* UNCERTAINTY = "passes/uncertainty.frag";

constexpr float END_STEPS = 65535;  // shared/ends.glsl

// Texture units, as in shaders/passes.
constexpr GLuint FIRST_FACTOR_UNIT = 3;  // to 7
constexpr GLuint ENDS_UNIT = 9;
constexpr GLuint UNCERTAIN_UNIT = 8;

struct Formats {
    GLenum total_absorbance, four_moments, two_moments;
};

Formats formats_of(const MomentKernel& kernel) {
    if (kernel.bits == 16) return {GL_R16F, GL_RGBA16, GL_RG16};
    return {GL_R32F, GL_RGBA32F, GL_RG32F};
}

// Defines what the passes of moments must know of the ends of a ray.
void define_ends(ShaderVariant& variant, const ResolvedParameters& parameters) {
    if (parameters.knows_ends()) variant.defines["KNOWN_ENDS"] = "1";
    if (parameters.in_own_interval()) variant.defines["OWN_INTERVAL"] = "1";
}

// The ends are stored by the first pass itself, unless it needs them, or cannot blend them in another way
// than the moments.
bool ends_with_moments(const ResolvedParameters& parameters, const Capabilities& gl) {
    return parameters.knows_ends() && !parameters.in_own_interval() &&
           (parameters.ordered || gl.blending_per_target);
}

}  // namespace

ShaderVariant moment_variant(const Technique& technique) {
    const MomentKernel& kernel = technique.moment_kernel();
    ShaderVariant variant = {
        .defines = {{"MOMENT_COUNT", std::to_string(technique.moments().moment_count)},
                    {"MOMENT_BITS", std::to_string(kernel.bits)}},
        .technique = fmt::format("shared/{}_moments.glsl", technique.moments().basis->key)};
    if (kernel.bits == 16 && kernel.moment_floats == technique.moments().moment_count)
        variant.constants = quantisation_glsl(technique.moments().moment_count);
    return variant;
}

ShaderVariant reconstruction_variant(const Technique& technique, const ResolvedParameters& parameters) {
    ShaderVariant variant = moment_variant(technique);
    if (parameters.textbook) variant.defines["TEXTBOOK_SOLVER"] = "1";
    if (parameters.factored_once) variant.defines["STORED_FACTOR"] = "1";
    if (parameters.estimation.estimate != Estimate::beta)
        variant.defines["ESTIMATE"] = std::to_string(static_cast<int>(parameters.estimation.estimate));
    define_ends(variant, parameters);
    return variant;
}

ShaderVariant factor_variant(const Technique& technique, const ResolvedParameters& parameters) {
    ShaderVariant variant = moment_variant(technique);
    define_ends(variant, parameters);
    return variant;
}

ShaderVariant accumulation_variant(const Technique& technique, const ResolvedParameters& parameters,
                                   const Capabilities& gl) {
    ShaderVariant variant = moment_variant(technique);
    define_access(variant, parameters.ordered ? gl.ordered : OrderedAccess::none);
    if (parameters.in_own_interval() || ends_with_moments(parameters, gl)) define_ends(variant, parameters);
    return variant;
}

MomentPasses::MomentPasses(const Technique& technique, glm::ivec2 size, GLuint depth, const Capabilities& gl)
    : technique_(technique), gl_(gl), depth_(depth), size_(size) {
    if (const std::string why = why_unavailable(technique, gl); !why.empty())
        throw Error(
            fmt::format("{} cannot be drawn here. {} Choose a variant of 32 bits.", technique.name, why));
    const int floats = technique.moment_kernel().moment_floats;
    const Formats formats = formats_of(technique.moment_kernel());
    total_absorbance_ = make_texture(formats.total_absorbance, size);
    moments_1_to_4_ = make_texture(formats.four_moments, size);
    if (floats > 4)
        moments_5_to_8_ = make_texture(floats > 6 ? formats.four_moments : formats.two_moments, size);
    weighted_color_ = make_texture(GL_RGBA16F, size);  // half floats, as in the evaluation of the paper
    std::vector<GLuint> targets = {total_absorbance_, moments_1_to_4_};
    if (floats > 4) targets.push_back(moments_5_to_8_);
    moment_target_ = make_framebuffer(targets, depth);
    depth_target_ = make_framebuffer({}, depth);
    color_target_ = make_framebuffer({weighted_color_}, depth);
}

// The targets that only some parameters need.
void MomentPasses::make_optional_targets(const ResolvedParameters& parameters) {
    if (parameters.knows_ends() && ends_ == 0) {
        ends_ = make_texture(ends_format(), size_);
        ends_target_ = make_framebuffer({ends_}, depth_);
        std::vector<GLuint> targets = {total_absorbance_, moments_1_to_4_};
        if (moments_5_to_8_ != 0) targets.push_back(moments_5_to_8_);
        targets.push_back(ends_);
        moments_and_ends_target_ = make_framebuffer(targets, depth_);
    }
    if (parameters.moves_uncertain() && uncertain_color_ == 0) {
        uncertain_color_ = make_texture(GL_RGBA16F, size_);
        uncertain_target_ = make_framebuffer({weighted_color_, uncertain_color_}, depth_);
    }
}

void MomentPasses::draw_ends(const PassInput& input) {
    clear_colors(ends_target_, 1);
    use_program(input.programs.get(SCENE, ENDS, input.lean({})));
    draw_transparent(input.scene, ends_target_, {.blending = Blending::greatest});
}

void MomentPasses::draw_moments(const PassInput& input) {
    make_optional_targets(input.parameters);
    has_ends_ = input.parameters.knows_ends();
    const bool with_ends = ends_with_moments(input.parameters, gl_);
    if (has_ends_ && !with_ends) draw_ends(input);
    const GLuint target = with_ends ? moments_and_ends_target_ : moment_target_;
    const GLuint colors = moments_5_to_8_ != 0 ? 3 : 2;  // of moments
    const bool ordered = input.parameters.ordered;
    if (const std::string why = why_unavailable(input.parameters, gl_); !why.empty()) throw Error(why);
    const bool by_images = ordered && gl_.ordered == OrderedAccess::interlock;
    factored_bias_.reset();
    clear_colors(target, static_cast<int>(colors) + (with_ends ? 1 : 0));
    if (by_images) {
        const Formats formats = formats_of(technique_.moment_kernel());
        const bool two = technique_.moment_kernel().moment_floats == 6;
        bind_image(0, total_absorbance_, formats.total_absorbance);
        bind_image(1, moments_1_to_4_, formats.four_moments);
        if (moments_5_to_8_ != 0)
            bind_image(2, moments_5_to_8_, two ? formats.two_moments : formats.four_moments);
        if (with_ends) bind_image(3, ends_, GL_RG16);
    }
    if (input.parameters.in_own_interval()) bind_texture(ENDS_UNIT, ends_);  // else they are drawn
    use_program(input.programs.get(SCENE, MOMENTS,
                                   input.lean(accumulation_variant(technique_, input.parameters, gl_))));
    DrawState state = {.blending = ordered ? Blending::none : Blending::add};
    if (with_ends && !ordered) state.greatest_target = colors;
    draw_transparent(input.scene, by_images ? depth_target_ : target, state);
    if (by_images) finish_shader_writes();
}

// Floats hold the same numbers where 16-bit numbers cannot be drawn.
GLenum MomentPasses::ends_format() const {
    return gl_.unorm16 ? GL_RG16 : GL_RG32F;
}

void MomentPasses::make_factors(int floats) {
    if (floats == factor_floats_) return;
    factor_floats_ = floats;
    factors_.clear();
    for (int left = floats; left > 0; left -= 4)
        factors_.push_back(make_texture(left == 1 ? GL_R32F : left == 2 ? GL_RG32F : GL_RGBA32F, size_));
    factor_targets_ = make_group_framebuffers(factors_, 0, gl_.color_targets);
}

// Factors depend on alpha, but not on beta or theta.
void MomentPasses::draw_factors(const PassInput& input) {
    if (factored_bias_ == input.parameters.alpha) return;
    // Without ends, b0 is read where the first pass stored it.
    make_factors(pixel_factor_floats(technique_, input.parameters) - (input.parameters.knows_ends() ? 0 : 1));
    bind_stored();
    set_draw_state({});
    for (std::size_t i = 0; i < factor_targets_.size(); ++i) {
        ShaderVariant variant = factor_variant(technique_, input.parameters);
        define_group(variant, i, factors_.size(), gl_.color_targets);
        bind_framebuffer(factor_targets_[i]);
        use_program(input.programs.get("passes/fullscreen.vert", FACTOR, variant));
        draw_fullscreen();
    }
    factored_bias_ = input.parameters.alpha;
}

void MomentPasses::draw_color(const PassInput& input) {
    if (input.parameters.factored_once) draw_factors(input);
    make_optional_targets(input.parameters);
    const bool uncertain = input.parameters.moves_uncertain();
    const GLuint target = uncertain ? uncertain_target_ : color_target_;
    clear_colors(target, uncertain ? 2 : 1);
    ShaderVariant variant = input.lean(input.lit(reconstruction_variant(technique_, input.parameters)));
    if (uncertain) variant.defines["UNCERTAIN"] = "1";
    use_program(input.programs.get(SCENE, COLOR, variant));
    bind_stored();
    draw_transparent(input.scene, target, {.blending = Blending::add});
}

void MomentPasses::draw_composite(const PassInput& input, GLuint target) {
    set_draw_state({});
    bind_framebuffer(target);
    ShaderVariant variant;
    if (input.parameters.moves_uncertain()) variant.defines["UNCERTAIN"] = "1";
    use_program(input.programs.get("passes/fullscreen.vert", "passes/composite.frag", variant));
    bind_texture(0, input.opaque_color);
    bind_texture(1, weighted_color_);
    bind_texture(2, total_absorbance_);
    bind_texture(UNCERTAIN_UNIT, uncertain_color_);
    draw_fullscreen();
}

bool MomentPasses::draw_diagnosis(const PassInput& input, Diagnosis diagnosis, GLuint target) {
    ResolvedParameters parameters = input.parameters;
    parameters.factored_once = false;  // stored factors do not say which pivots were raised
    ShaderVariant variant;
    if (diagnosis == Diagnosis::uncertainty) {
        parameters.textbook = false;  // the textbook solver knows no bounds
        variant = input.lit(reconstruction_variant(technique_, parameters));
    } else {
        variant = reconstruction_variant(technique_, parameters);
    }
    const char* fragment_shader = diagnosis == Diagnosis::uncertainty ? UNCERTAINTY : FAILURES;
    use_program(input.programs.get(SCENE, fragment_shader, variant));
    bind_stored();
    draw_transparent(input.scene, target, {.blending = Blending::add});
    return true;
}

std::optional<ShaderVariant> MomentPasses::bind_for_capture(const ResolvedParameters& parameters) const {
    bind_stored();
    return reconstruction_variant(technique_, parameters);
}

std::vector<MomentVector> MomentPasses::read_moments(const TexelRect& rect) const {
    const int floats = technique_.moment_kernel().moment_floats;
    const std::vector<float> absorbances = read_texture(total_absorbance_, rect, 1);
    const std::vector<float> first = read_texture(moments_1_to_4_, rect, 4);
    const std::vector<float> second =
        floats > 4 ? read_texture(moments_5_to_8_, rect, floats - 4) : std::vector<float>();
    const std::vector<float> ends = has_ends_ ? read_texture(ends_, rect, 2) : std::vector<float>();
    check_gl("reading moments");
    const std::size_t count = absorbances.size(), per_pixel = static_cast<std::size_t>(floats);
    std::vector<MomentVector> moments(count);
    for (std::size_t i = 0; i < count; ++i) {
        moments[i].b0 = absorbances[i];
        for (std::size_t k = 0; k < per_pixel; ++k)
            moments[i].b[k] = k < 4 ? first[4 * i + k] : second[(per_pixel - 4) * i + k - 4];
        if (has_ends_) {
            moments[i].near_step = std::round(ends[2 * i] * END_STEPS);
            moments[i].far_step = std::round(ends[2 * i + 1] * END_STEPS);
        }
    }
    return moments;
}

void MomentPasses::bind_stored() const {
    bind_texture(0, total_absorbance_);
    bind_texture(1, moments_1_to_4_);
    bind_texture(2, moments_5_to_8_);
    for (std::size_t i = 0; i < factors_.size(); ++i)
        bind_texture(FIRST_FACTOR_UNIT + static_cast<GLuint>(i), factors_[i]);
    bind_texture(ENDS_UNIT, ends_);
}

}  // namespace momentscope
