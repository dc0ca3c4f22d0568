#include "core/render/shadow_maps.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/gl/buffer.hpp"
#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/gl_info.hpp"
#include "core/gl/query.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/uniform_blocks.hpp"
#include "core/shadow/shadow_filter.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr const char* CASTERS = "passes/scene.vert";
constexpr const char* FULLSCREEN = "passes/fullscreen.vert";
constexpr const char* FILTER = "passes/shadow_filter.frag";
constexpr GLuint LIGHT_BLOCK = 2;  // passes/light_block.glsl, light.glsl
constexpr GLuint OPAQUE_UNIT = 12, TRANSPARENT_UNIT = 13, DEEP_STEPS_UNIT = 14;
constexpr const char *DIRECTION = "direction", *LAYER = "layer";  // shadow_filter.frag
constexpr std::size_t MAX_BYTES = std::size_t{1} << 30;

// Where 16-bit numbers cannot be drawn, floats hold what is rounded elsewhere.
GLenum opaque_format(const OpaqueShadow& row, const Capabilities& gl) {
    if (row.bits == 16 && gl.unorm16) return GL_RGBA16;
    return row.numbers == 2 ? GL_RG32F : GL_RGBA32F;
}

// Throws Error if this GL cannot hold the maps, before they take memory.
void require_fitting(const ShadowSettings& settings) {
    const int most = most_texels_of_a_side();
    if (settings.size > most)
        throw Error(fmt::format(
            "A shadow map of {0}x{0} texels is larger than the {1}x{1} that this GL can draw; give a "
            "smaller --shadow-size.",
            settings.size, most));
    const auto texels = static_cast<std::size_t>(settings.size) * static_cast<std::size_t>(settings.size);
    const std::size_t bytes = texels * (116 + 32 * static_cast<std::size_t>(caster_layers(settings)));
    if (bytes > MAX_BYTES)
        throw Error(fmt::format(
            "Shadow maps of {0}x{0} texels take {1} MB, more than the limit of {2} MB; give a smaller "
            "--shadow-size.",
            settings.size, bytes >> 20U, MAX_BYTES >> 20U));
}

bool same_place(const ShadowSettings& a, const ShadowSettings& b) {
    return a.size == b.size && a.light == b.light && a.distance == b.distance;
}

// True if the texels of transparent casters hold the same sums for both settings.
bool same_sums(const ShadowSettings& a, const ShadowSettings& b) {
    const Technique& technique = *a.transparent.technique;
    if (&technique != b.transparent.technique || a.casters != b.casters) return false;
    const ResolvedParameters before = resolve(a.transparent.values, technique);
    const ResolvedParameters after = resolve(b.transparent.values, technique);
    return texel_numbers(a.transparent) == texel_numbers(b.transparent) &&
           (!technique.on_circle() || before.theta == after.theta);
}

}  // namespace

ShadowMaps::ShadowMaps(PassTiming timing, std::shared_ptr<ProgramCache> programs)
    : timing_(timing),
      timer_(make_query()),
      frame_block_(make_buffer(sizeof(FrameBlock))),
      light_block_(make_buffer(sizeof(LightBlock))),
      programs_(std::move(programs)) {}

// Waits for the GL, as drawing a picture does.
template <typename Draw>
void ShadowMaps::run(ShadowStage& stage, const Draw& draw) {
    set_viewport(glm::ivec2(settings_->size));
    PassTimer timer(timing_, timer_);
    draw();
    stage.milliseconds = timer.milliseconds();
    ++stage.runs;
}

void ShadowMaps::update(const SceneBuffers& scene, const Sphere& casters, const ShadowSettings& settings) {
    const LightCamera frame = light_camera(settings, casters);
    require_fitting(settings);
    const std::optional<ShadowSettings> last = std::exchange(settings_, std::nullopt);  // until all succeeded
    const bool size = !last || last->size != settings.size;
    const bool place = size || !same_place(*last, settings);
    const bool sums = place || !same_sums(*last, settings);
    const bool radius = !last || last->radius != settings.radius;
    const bool opaque_row = size || last->opaque != settings.opaque;
    frame_ = frame;
    lighting_ = shader_lighting(settings);
    settings_ = settings;
    try {
        if (size) make_depths();
        if (opaque_row) make_opaque();
        if (size || caster_layers(*last) != caster_layers(settings)) make_sums();
        write_blocks(glm::mat4(1));
        bind_uniforms(0, frame_block_);
        bind_uniforms(LIGHT_BLOCK, light_block_);
        if (place) run(stages_.opaque_render, [&] { draw_opaque(scene); });
        if (place || radius || opaque_row) run(stages_.opaque_filter, [&] { filter_opaque(); });
        if (sums) run(stages_.transparent_render, [&] { draw_sums(scene); });
        if (sums || radius) run(stages_.transparent_filter, [&] { filter_sums(); });
        leave_nothing_bound();
        check_gl("drawing shadow maps");
    } catch (...) {
        settings_.reset();
        throw;
    }
}

void ShadowMaps::make_depths() {
    const glm::ivec2 size(settings_->size);
    nearest_ = make_texture(GL_R32F, size);
    nearest_depth_ = make_texture(GL_DEPTH_COMPONENT32F, size);
    nearest_target_ = make_framebuffer({nearest_}, nearest_depth_);
    texels_ = std::make_unique<CasterTexels>(settings_->size, programs_);
    check_gl(fmt::format("making shadow maps of {}x{} texels", size.x, size.y));
}

void ShadowMaps::make_opaque() {
    const glm::ivec2 size(settings_->size);
    opaque_filtered_ = {};
    opaque_halfway_ = {};
    if (settings_->opaque->unfiltered) return;
    opaque_filtered_ = make_texture(opaque_format(*settings_->opaque, programs_->gl()), size);
    opaque_target_ = make_framebuffer({opaque_filtered_}, 0);
    opaque_halfway_ = make_layered_texture(GL_RGBA32F, size, 1);
    opaque_halfway_target_ = make_layer_framebuffer(opaque_halfway_, 0, 1);
    check_gl(fmt::format("making shadow maps of {}x{} texels", size.x, size.y));
}

void ShadowMaps::make_sums() {
    const glm::ivec2 size(settings_->size);
    const int layers = caster_layers(*settings_);
    filtered_targets_.clear();
    sums_ = {};
    filtered_ = {};
    halfway_ = {};
    deep_ = {};
    if (layers == 0) return;
    sums_ = make_layered_texture(GL_RGBA32F, size, layers);
    filtered_ = make_layered_texture(GL_RGBA32F, size, layers);
    halfway_ = make_layered_texture(GL_RGBA32F, size, 1);
    sums_target_ = make_layer_framebuffer(sums_, 0, layers);
    halfway_target_ = make_layer_framebuffer(halfway_, 0, 1);
    for (int layer = 0; layer < layers; ++layer)
        filtered_targets_.push_back(make_layer_framebuffer(filtered_, layer, 1));
    check_gl(fmt::format("making shadow maps of {}x{} texels", size.x, size.y));
}

// Writes the uniform blocks. In these passes the light is the eye.
void ShadowMaps::write_blocks(const glm::mat4& eye_view) const {
    const glm::vec3 warp = depth_warp_factors(frame_.warp);
    const FrameBlock frame = {frame_.view,
                              frame_.projection,
                              glm::vec4(warp.x, warp.y, frame_.near_plane, frame_.far_plane),
                              glm::vec4(0),
                              {},
                              glm::ivec4(settings_->size, settings_->size, 1, 0)};
    write_buffer(frame_block_, frame);
    const ResolvedParameters parameters =
        resolve(settings_->transparent.values, *settings_->transparent.technique);
    LightBlock light = {};
    light.view_from_eye = glm::mat4(glm::dmat4(frame_.view) * glm::inverse(glm::dmat4(eye_view)));
    light.projection = frame_.projection;
    light.position = eye_view * glm::vec4(frame_.position, 1);
    light.range = glm::vec4(warp.x, warp.y, static_cast<float>(settings_->size), 0);
    light.reconstruction = glm::vec4(
        parameters.beta, basis_parameter(parameters, *settings_->transparent.technique), parameters.alpha, 0);
    light.radius = glm::ivec4(settings_->radius);
    const std::vector<float> weights = gaussian_weights(settings_->radius);
    for (std::size_t i = 0; i < weights.size(); ++i)
        light.weights[i / 4][static_cast<int>(i % 4)] = weights[i];
    write_buffer(light_block_, light);
}

void ShadowMaps::draw_opaque(const SceneBuffers& scene) {
    clear_color(nearest_target_, 0, glm::vec4(1));
    clear_depth(nearest_target_, 1);
    set_draw_state({.depth = DepthTest::nearer});
    bind_framebuffer(nearest_target_);
    use_program(programs_->get(CASTERS, "passes/caster_depth.frag"));
    scene.draw(Surfaces::opaque_casters);
}

void ShadowMaps::draw_sums(const SceneBuffers& scene) {
    if (!settings_->casters) return;
    if (settings_->deep()) {
        deep_ = make_deep_shadow_map(*texels_, scene, frame_block_, settings_->size);
        return;
    }
    const int layers = caster_layers(*settings_);
    ShaderVariant variant;
    add_lighting(variant, lighting_);
    clear_colors(sums_target_, layers);
    use_program(programs_->get(CASTERS, "passes/caster.frag", variant));
    draw_transparent(scene, sums_target_, {.blending = Blending::add});
}

void ShadowMaps::filter_opaque() {
    if (settings_->opaque->unfiltered) return;
    ShaderVariant of_depths;
    add_lighting(of_depths, lighting_);
    of_depths.defines["OPAQUE_DEPTHS"] = "1";
    set_draw_state({});
    bind_framebuffer(opaque_halfway_target_);
    const GLuint depth_filter = programs_->get(FULLSCREEN, FILTER, of_depths);
    use_program(depth_filter);
    set_uniform(depth_filter, DIRECTION, glm::ivec2(1, 0));
    bind_texture(0, nearest_);
    draw_fullscreen();
    bind_framebuffer(opaque_target_);
    const GLuint filter = programs_->get(FULLSCREEN, FILTER);
    use_program(filter);
    set_uniform(filter, DIRECTION, glm::ivec2(0, 1));
    set_uniform(filter, LAYER, 0);
    bind_layered_texture(0, opaque_halfway_);
    draw_fullscreen();
}

void ShadowMaps::filter_sums() {
    if (filtered_targets_.empty()) return;
    set_draw_state({});
    const GLuint filter = programs_->get(FULLSCREEN, FILTER);
    use_program(filter);
    for (std::size_t layer = 0; layer < filtered_targets_.size(); ++layer) {
        bind_framebuffer(halfway_target_);
        set_uniform(filter, DIRECTION, glm::ivec2(1, 0));
        set_uniform(filter, LAYER, static_cast<int>(layer));
        bind_layered_texture(0, sums_);
        draw_fullscreen();
        bind_framebuffer(filtered_targets_[layer]);
        set_uniform(filter, DIRECTION, glm::ivec2(0, 1));
        set_uniform(filter, LAYER, 0);
        bind_layered_texture(0, halfway_);
        draw_fullscreen();
    }
}

void ShadowMaps::bind(const glm::mat4& eye_view) const {
    write_blocks(eye_view);
    bind_uniforms(LIGHT_BLOCK, light_block_);
    bind_texture(OPAQUE_UNIT, settings_->opaque->unfiltered ? nearest_ : opaque_filtered_);
    if (settings_->deep()) {
        bind_texture(TRANSPARENT_UNIT, deep_.lists);
        bind_texture(DEEP_STEPS_UNIT, deep_.steps);
    } else if (settings_->casters) {
        bind_layered_texture(TRANSPARENT_UNIT, filtered_);
    }
}

ShadowFilterSamples ShadowMaps::capture(const SceneBuffers& scene, const ShadowMapPosition& place) {
    const ShadowMapTextures maps = {nearest_, opaque_filtered_, filtered_, filtered_targets_.size()};
    return capture_filter_region(*texels_, scene, frame_block_, maps, frame_, *settings_, place);
}

}  // namespace momentscope
