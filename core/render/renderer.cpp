#include "core/render/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <glm/gtc/matrix_transform.hpp>

#include "core/gl/buffer.hpp"
#include "core/gl/query.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/uniform_blocks.hpp"
#include "core/scene/camera.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr const char* TONE_MAP = "tone_map";  // display.frag

}  // namespace

Renderer::Renderer(std::shared_ptr<ProgramCache> programs) : programs_(std::move(programs)) {
    timing_ = reliable_timing(gl_info(gl()));
    frame_block_ = make_buffer(sizeof(FrameBlock));
    timer_ = make_query();
}

Renderer::~Renderer() = default;

void Renderer::set_scene(const Scene& scene) {
    buffers_ = std::make_unique<SceneBuffers>(scene);  // may fail; then the last scene stays
    bounds_ = transparent_bounds(scene);
    casters_ = caster_bounds(scene);
    light_ = scene.light;
    shadow_maps_.reset();
    background_ = scene.background;
    view_.technique = nullptr;  // everything is stale
}

void Renderer::render(const View& view) {
    const Stage stage = first_stale_stage(view_, view);
    if (stage == Stage::nothing) return;
    if (const char* why = why_refused(*view.technique, view.parameters); why != nullptr) throw Error(why);
    view_.technique = nullptr;  // nullptr until everything succeeded
    if (view.size != view_.size) {
        view_.size = {0, 0};  // after a failure halfway, sizes must not differ
        resize(view.size);
    }
    const bool technique_changed = transparency_of_ != view.technique;
    if (technique_changed || transparency_ == nullptr) {
        transparency_.reset();  // frees its memory before the next one takes more
        transparency_ = make_transparency(*view.technique, view.size, depth_, gl());
        transparency_of_ = view.technique;
    }
    view_ = view;
    buffers_->set_order(submission_order(view.parameters));
    update_frame_block(view);
    try {
        update_shadows(view);
        run_from(stage);
        check_gl("drawing the scene");
    } catch (...) {
        view_.technique = nullptr;
        transparency_.reset();  // its textures may not exist
        throw;
    }
}

void Renderer::resize(glm::ivec2 size) {
    const int most = std::min(MAX_PICTURE_SIDE, most_texels_of_a_side());
    if (std::min(size.x, size.y) < 1 || std::max(size.x, size.y) > most)
        throw Error(fmt::format("A picture of {}x{} pixels cannot be drawn; give a size from 1x1 to {}x{}.",
                                size.x, size.y, most, most));
    transparency_.reset();
    capture_.reset();
    failures_.reset();
    uncertainty_.reset();
    probe_.reset();
    opaque_color_ = make_texture(GL_RGBA16F, size);
    depth_ = make_texture(GL_DEPTH_COMPONENT32F, size);
    picture_ = make_texture(GL_RGBA32F, size);
    display_color_ = make_texture(GL_RGBA8, size);
    opaque_target_ = make_framebuffer({opaque_color_}, depth_);
    picture_target_ = make_framebuffer({picture_}, 0);
    display_target_ = make_framebuffer({display_color_}, 0);
    capture_ = std::make_unique<FragmentCapture>(size, depth_, gl());
    check_gl(fmt::format("making textures of {}x{} pixels", size.x, size.y));
}

void Renderer::update_frame_block(const View& view) {
    warp_ = depth_warp(view.camera, bounds_);
    parameters_ = resolve(view.parameters, *view.technique);
    const ResolvedParameters& p = parameters_;
    const glm::vec3 warp = depth_warp_factors(warp_);
    const float aspect = static_cast<float>(view.size.x) / static_cast<float>(view.size.y);
    std::array<float, MAX_BASIS_FLOATS> basis{};
    if (view.technique->has_moments())
        basis = view.technique->moment_kernel().basis(basis_parameter(p, *view.technique));
    const FrameBlock block = {view_matrix(view.camera),
                              projection_matrix(view.camera, aspect),
                              glm::vec4(warp.x, warp.y, NEAR_PLANE, FAR_PLANE),
                              glm::vec4(p.beta, p.alpha, p.renormalizes() ? 1 : 0, 0),
                              std::bit_cast<std::array<glm::vec4, 2>>(basis),
                              glm::ivec4(view.size, warp.z, 0)};
    write_buffer(frame_block_, block);
}

bool Renderer::lit() const {
    return has_shadows(view_.parameters) && shadow_maps_ != nullptr;
}

PassInput Renderer::pass_input() const {
    return {*programs_,
            *buffers_,
            view_.size,
            opaque_color_,
            depth_,
            parameters_,
            lit() ? &shadow_maps_->lighting() : nullptr};
}

void Renderer::update_shadows(const View& view) {
    if (!has_shadows(view.parameters)) return;
    if (shadow_maps_ == nullptr) shadow_maps_ = std::make_unique<ShadowMaps>(timing_, programs_);
    shadow_maps_->update(*buffers_, casters_, shadow_settings(view.parameters, light_));
}

void Renderer::draw_opaque() {
    clear_color(opaque_target_, 0, glm::vec4(background_, 1));
    clear_depth(opaque_target_, 1);
    set_draw_state({.depth = DepthTest::nearer});
    bind_framebuffer(opaque_target_);
    use_program(programs_->get("passes/scene.vert", "passes/opaque.frag", pass_input().lit({})));
    buffers_->draw(Surfaces::opaque);
}

// Waits for the GL. The capture that follows a picture would wait anyway.
template <typename Draw>
void Renderer::timed(double& milliseconds, const Draw& draw) {
    PassTimer timer(timing_, timer_);
    draw();
    milliseconds = timer.milliseconds();
}

void Renderer::redraw() {
    assert(view_.technique != nullptr && "there is no picture to draw again");
    run_from(Stage::moments);
    check_gl("drawing the scene again");
}

void Renderer::run_from(Stage stage) {
    probe_.reset();
    set_viewport(view_.size);
    bind_uniforms(0, frame_block_);
    if (lit()) shadow_maps_->bind(view_matrix(view_.camera));
    const PassInput input = pass_input();
    if (stage <= Stage::opaque || stage == Stage::shading) {
        timed(times_.opaque, [&] { draw_opaque(); });
        ++counts_.opaque;
    }
    if (stage <= Stage::moments) {
        timed(times_.moments, [&] { transparency_->draw_moments(input); });
        ++counts_.moments;
    }
    if (stage <= Stage::color) {
        timed(times_.color, [&] { transparency_->draw_color(input); });
        ++counts_.color;
    }
    if (stage <= Stage::composite) {
        timed(times_.composite, [&] { transparency_->draw_composite(input, picture_target_); });
        ++counts_.composite;
    }
    set_draw_state({});
    bind_framebuffer(display_target_);
    const GLuint display = programs_->get("passes/fullscreen.vert", "passes/display.frag");
    use_program(display);
    set_uniform(display, TONE_MAP, static_cast<int>(tone_map_of(view_.parameters)));
    bind_texture(0, picture_);
    draw_fullscreen();
    leave_nothing_bound();
}

Image Renderer::read_picture() const {
    return read_region({0, 0}, view_.size);
}

Image Renderer::read_region(glm::ivec2 corner, glm::ivec2 extent) const {
    const TexelRect rect = {{corner.x, view_.size.y - corner.y - extent.y}, extent};
    Image image;
    image.width = extent.x;
    image.height = extent.y;
    image.pixels = read_colors(picture_, rect);
    check_gl("reading pixels");
    image.flip_rows();
    return image;
}

DrawnPicture Renderer::drawn() const {
    assert(transparency_ != nullptr && "there is no picture");
    return {view_, pass_input(), *transparency_, warp_, frame_block_, shadow_maps()};
}

PixelCapture Renderer::capture_pixel(glm::ivec2 pixel) {
    return capture_region(pixel, {1, 1}).front();
}

std::vector<PixelCapture> Renderer::capture_region(glm::ivec2 corner, glm::ivec2 extent) {
    return capture_->region(drawn(), corner, extent);
}

std::vector<float> Renderer::fragment_lights(glm::ivec2 pixel) {
    return capture_->lights(drawn(), pixel);
}

std::optional<LitSurface> Renderer::lit_surface(glm::ivec2 pixel) {
    if (probe_ == nullptr) probe_ = std::make_unique<LightProbe>(drawn(), depth_);
    return probe_->surface(pixel);
}

glm::vec3 Renderer::world_place(glm::ivec2 pixel, float view_depth) const {
    const glm::vec2 size(view_.size);
    const glm::mat4 projection = projection_matrix(view_.camera, size.x / size.y);
    const glm::vec2 place((static_cast<float>(pixel.x) + 0.5f) / size.x * 2 - 1,
                          1 - (static_cast<float>(pixel.y) + 0.5f) / size.y * 2);
    const glm::dvec4 eye(place.x * view_depth / projection[0][0], place.y * view_depth / projection[1][1],
                         -view_depth, 1);
    return {glm::inverse(glm::dmat4(view_matrix(view_.camera))) * eye};
}

ShadowFilterSamples Renderer::capture_light(glm::ivec2 pixel, float view_depth) {
    assert(lit() && "the picture has no shadows");
    const ShadowMapPosition place =
        light_place(shadow_maps_->frame(), shadow_maps_->settings().size, world_place(pixel, view_depth));
    return shadow_maps_->capture(*buffers_, place);
}

std::optional<FailureCounts> Renderer::draw_failures() {
    if (failures_ == nullptr) failures_ = std::make_unique<FailureMarks>(view_.size, depth_);
    return failures_->draw(drawn());
}

std::vector<float> Renderer::uncertainty() {
    if (uncertainty_ == nullptr) uncertainty_ = std::make_unique<UncertaintyMap>(view_.size, depth_);
    return uncertainty_->draw(drawn());
}

}  // namespace momentscope
