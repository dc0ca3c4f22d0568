#include "core/render/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/error.hpp"
#include "core/gl/texture.hpp"
#include "core/render/low_footprint.hpp"
#include "core/render/moment_passes.hpp"
#include "core/render/uniform_blocks.hpp"
#include "core/scene/camera.hpp"

namespace momentscope {

namespace {

constexpr std::size_t PIXEL_LIST_CAPACITY = 65'536;
constexpr GLint TONE_MAP_LOCATION = 0;  // display.frag

void require_gl_4_5() {
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 45)
        throw Error(
            fmt::format("This GL is version {}.{}; Momentscope needs OpenGL 4.5. Update the driver, or use "
                        "--headless, which renders in software.",
                        major, minor));
}

// Which is not the order in which nodes were appended.
std::vector<FragmentNode> in_submission_order(std::vector<FragmentNode> nodes) {
    std::ranges::sort(nodes, {},
                      [](const FragmentNode& node) { return std::pair(node.draw, node.primitive); });
    return nodes;
}

Fragment fragment_of(const FragmentNode& node, const SceneBuffers& scene) {
    return {.depth = node.depth,
            .view_depth = node.view_depth,
            .opacity = node.color_opacity.a,
            .color = glm::vec3(node.color_opacity),
            .draw = node.draw,
            .primitive = node.primitive,
            .seed = fragment_seed(node.pixel, scene.object_of_draw(node.draw),
                                  std::bit_cast<std::uint32_t>(node.view_depth)),
            .threshold = node.threshold};
}

// What draws next may put back what it found, which must then still exist.
void leave_nothing_bound() {
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace

Renderer::Renderer() : Renderer(momentscope::ordered_access()) {}

Renderer::Renderer(OrderedAccess access) : access_(access) {
    require_gl_4_5();
    GLuint name = 0;
    glCreateBuffers(1, &name);
    frame_block_ = GlBuffer(name);
    glNamedBufferStorage(frame_block_, sizeof(FrameBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    opaque_program_ = link_program("passes/scene.vert", "passes/opaque.frag");
    display_program_ = link_program("passes/fullscreen.vert", "passes/display.frag");
    glCreateQueries(GL_TIME_ELAPSED, 1, &name);
    timer_ = GlQuery(name);
}

Renderer::~Renderer() = default;

void Renderer::set_scene(const Scene& scene) {
    buffers_ = std::make_unique<SceneBuffers>(scene);  // may fail; the last scene stays then
    bounds_ = transparent_bounds(scene);
    background_ = scene.background;
    view_.technique = nullptr;  // everything is stale
}

void Renderer::render(const View& view) {
    const Stage stage = first_stale_stage(view_, view);
    if (stage == Stage::nothing) return;
    if (const char* why = why_refused(*view.technique, view.parameters); why != nullptr) throw Error(why);
    view_.technique = nullptr;  // until all went well
    if (view.size != view_.size) {
        view_.size = {0, 0};  // a failure halfway must not leave textures of one size beside the other
        resize(view.size);
    }
    const bool technique_changed = transparency_of_ != view.technique;
    if (technique_changed || transparency_ == nullptr) {
        transparency_.reset();  // free its memory before the next takes its own
        transparency_ = make_transparency(*view.technique, view.size, depth_, access_);
        transparency_of_ = view.technique;
    }
    view_ = view;
    buffers_->set_order(submission_order(view.parameters));
    update_frame_block(view);
    try {
        run_from(stage);
        check_gl("drawing the scene");
    } catch (...) {
        view_.technique = nullptr;
        transparency_.reset();  // its textures may not exist
        throw;
    }
}

void Renderer::resize(glm::ivec2 size) {
    if (std::min(size.x, size.y) < 1 || std::max(size.x, size.y) > MAX_PICTURE_SIDE)
        throw Error(fmt::format("A picture of {}x{} pixels cannot be drawn; give a size from 1x1 to {}x{}.",
                                size.x, size.y, MAX_PICTURE_SIDE, MAX_PICTURE_SIDE));
    transparency_.reset();
    pixel_list_.reset();
    failure_counts_ = {};
    opaque_color_ = make_texture(GL_RGBA16F, size);
    depth_ = make_texture(GL_DEPTH_COMPONENT32F, size);
    picture_ = make_texture(GL_RGBA32F, size);
    display_color_ = make_texture(GL_RGBA8, size);
    opaque_target_ = make_framebuffer({opaque_color_}, depth_);
    picture_target_ = make_framebuffer({picture_}, 0);
    display_target_ = make_framebuffer({display_color_}, 0);
    pixel_list_ = std::make_unique<FragmentList>(size, PIXEL_LIST_CAPACITY, depth_);
    check_gl(fmt::format("making textures of {}x{} pixels", size.x, size.y));
}

void Renderer::update_frame_block(const View& view) {
    warp_ = depth_warp(view.camera, bounds_);
    parameters_ = resolve(view.parameters, *view.technique);
    const ResolvedParameters& p = parameters_;
    const glm::vec2 warp = depth_warp_factors(warp_);
    const float aspect = static_cast<float>(view.size.x) / static_cast<float>(view.size.y);
    const FrameBlock block = {view_matrix(view.camera), projection_matrix(view.camera, aspect),
                              glm::vec4(warp, NEAR_PLANE, FAR_PLANE),
                              glm::vec4(p.beta, p.theta, p.alpha, p.renormalize ? 1 : 0),
                              glm::ivec4(view.size, 0, 0)};
    glNamedBufferSubData(frame_block_, 0, sizeof(block), &block);
}

PassInput Renderer::pass_input() const {
    return {*buffers_, view_.size, opaque_color_, depth_, parameters_};
}

void Renderer::draw_opaque() {
    const float background[4] = {background_.r, background_.g, background_.b, 1};
    const float far = 1;
    glClearNamedFramebufferfv(opaque_target_, GL_COLOR, 0, background);
    glClearNamedFramebufferfv(opaque_target_, GL_DEPTH, 0, &far);
    glBindFramebuffer(GL_FRAMEBUFFER, opaque_target_);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(opaque_program_);
    buffers_->draw(Surfaces::opaque);
    glDisable(GL_DEPTH_TEST);
}

// Waits for the GL, as the capture that follows a picture does anyway.
template <typename Draw>
void Renderer::timed(double& milliseconds, const Draw& draw) {
    glBeginQuery(GL_TIME_ELAPSED, timer_);
    try {
        draw();
    } catch (...) {
        glEndQuery(GL_TIME_ELAPSED);  // or the next picture could not begin one
        throw;
    }
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(timer_, GL_QUERY_RESULT, &nanoseconds);
    milliseconds = 1e-6 * static_cast<double>(nanoseconds);
}

void Renderer::run_from(Stage stage) {
    glViewport(0, 0, view_.size.x, view_.size.y);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    const PassInput input = pass_input();
    if (stage <= Stage::opaque) {
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
        glBindFramebuffer(GL_FRAMEBUFFER, picture_target_);
        timed(times_.composite, [&] { transparency_->draw_composite(input); });
        ++counts_.composite;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, display_target_);
    glUseProgram(display_program_);
    glUniform1i(TONE_MAP_LOCATION, static_cast<GLint>(tone_map_of(view_.parameters)));
    glBindTextureUnit(0, picture_);
    draw_fullscreen();
    leave_nothing_bound();
}

Image Renderer::read_picture() const {
    Image image(view_.size.x, view_.size.y);
    glGetTextureImage(picture_, 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(image.pixels.size() * sizeof(glm::vec4)), image.pixels.data());
    check_gl("reading the picture");
    image.flip_rows();
    return image;
}

Image Renderer::read_region(glm::ivec2 corner, glm::ivec2 extent) const {
    Image image(extent.x, extent.y);
    glGetTextureSubImage(picture_, 0, corner.x, view_.size.y - corner.y - extent.y, 0, extent.x, extent.y, 1,
                         GL_RGBA, GL_FLOAT, static_cast<GLsizei>(image.pixels.size() * sizeof(glm::vec4)),
                         image.pixels.data());
    check_gl("reading pixels");
    image.flip_rows();
    return image;
}

std::optional<FailureCounts> Renderer::draw_failures() {
    if (failure_counts_ == 0) {
        failure_counts_ = make_texture(GL_RG16F, view_.size);
        failure_color_ = make_texture(GL_RGBA8, view_.size);
        failure_target_ = make_framebuffer({failure_counts_}, depth_);
        failure_color_target_ = make_framebuffer({failure_color_}, 0);
    }
    if (failure_color_program_ == 0)
        failure_color_program_ = link_program("passes/fullscreen.vert", "passes/failure_colors.frag");
    const float zero[4] = {0, 0, 0, 0};
    glClearNamedFramebufferfv(failure_target_, GL_COLOR, 0, zero);
    glViewport(0, 0, view_.size.x, view_.size.y);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    glBindFramebuffer(GL_FRAMEBUFFER, failure_target_);
    if (!transparency_->draw_failures(pass_input())) return std::nullopt;
    glBindFramebuffer(GL_FRAMEBUFFER, failure_color_target_);
    glUseProgram(failure_color_program_);
    glBindTextureUnit(0, failure_counts_);
    draw_fullscreen();
    leave_nothing_bound();
    std::vector<glm::vec2> counts(static_cast<std::size_t>(view_.size.x) *
                                  static_cast<std::size_t>(view_.size.y));
    glGetTextureImage(failure_counts_, 0, GL_RG, GL_FLOAT,
                      static_cast<GLsizei>(counts.size() * sizeof(glm::vec2)), counts.data());
    check_gl("marking failed reconstructions");
    FailureCounts total;
    for (const glm::vec2& count : counts) {
        if (count.x > 0.5f)
            ++total.failed;
        else if (count.y > 0.5f)
            ++total.clamped;
    }
    return total;
}

GLuint Renderer::capture_program(bool& has_transmittance) {
    std::optional<ShaderVariant> reconstructing = transparency_->bind_for_capture(parameters_);
    has_transmittance = reconstructing.has_value();
    ShaderVariant variant = reconstructing.value_or(ShaderVariant());
    if (has_transmittance) variant.defines["WITH_TRANSMITTANCE"] = "1";
    return capture_programs_.get("passes/scene.vert", "passes/capture.frag", variant);
}

PixelCapture Renderer::capture_pixel(glm::ivec2 pixel) {
    return capture_region(pixel, {1, 1}).front();
}

std::vector<PixelCapture> Renderer::capture_region(glm::ivec2 corner, glm::ivec2 extent) {
    assert(transparency_ != nullptr && "capturing needs a picture");
    bool has_transmittance = false;
    const GLuint program = capture_program(has_transmittance);
    glViewport(0, 0, view_.size.x, view_.size.y);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    const glm::ivec2 lower_left(corner.x, view_.size.y - corner.y - extent.y);
    const std::size_t count = pixel_list_->capture(pass_input(), program, lower_left, extent);
    if (count > pixel_list_->capacity() && extent.x * extent.y > 1) {  // in two halves
        const bool rows = extent.y > 1;
        const glm::ivec2 half = rows ? glm::ivec2(extent.x, extent.y / 2) : glm::ivec2(extent.x / 2, 1);
        const glm::ivec2 step = rows ? glm::ivec2(0, half.y) : glm::ivec2(half.x, 0);
        std::vector<PixelCapture> captures = capture_region(corner, half);
        std::ranges::move(capture_region(corner + step, extent - step), std::back_inserter(captures));
        return captures;
    }
    std::vector<PixelCapture> captures =
        sort_captures(pixel_list_->read(count), lower_left, extent, has_transmittance);
    if (const auto low = transparency_->low_target()) add_shares(captures, *low, lower_left, extent);
    leave_nothing_bound();
    check_gl("capturing pixels");
    return captures;
}

// Low-resolution moments are made of the fragments of their own pixels, which are captured there.
void Renderer::add_shares(std::vector<PixelCapture>& captures, const Transparency::LowTarget& low,
                          glm::ivec2 lower_left, glm::ivec2 extent) {
    const LowFootprint footprint(view_.size, low.size, lower_left, extent);
    FragmentList list(low.size, PIXEL_LIST_CAPACITY, low.depth);
    glViewport(0, 0, low.size.x, low.size.y);
    const GLuint program = capture_programs_.get("passes/scene.vert", "passes/capture.frag");
    std::vector<std::vector<Fragment>> of_pixel;
    for (int y = 0; y < footprint.extent().y; ++y) {  // row by row, so that the list holds them
        const std::size_t count = list.capture(pass_input(), program, footprint.corner() + glm::ivec2(0, y),
                                               {footprint.extent().x, 1});
        if (count > list.capacity())
            throw Error(
                fmt::format("A row of low-resolution moments has {} fragments; at most {} can be "
                            "captured. Choose a smaller picture.",
                            count, list.capacity()));
        of_pixel.resize(of_pixel.size() + static_cast<std::size_t>(footprint.extent().x));
        for (const FragmentNode& node : in_submission_order(list.read(count))) {
            const int x = static_cast<int>(node.pixel & 0xffffU) - footprint.corner().x;
            of_pixel[of_pixel.size() - static_cast<std::size_t>(footprint.extent().x - x)].push_back(
                fragment_of(node, *buffers_));
        }
    }
    glViewport(0, 0, view_.size.x, view_.size.y);
    for (std::size_t i = 0; i < captures.size(); ++i) {
        const int column = static_cast<int>(i) % extent.x, row = static_cast<int>(i) / extent.x;
        captures[i].ray.shares =
            footprint.shares_of({lower_left.x + column, lower_left.y + extent.y - 1 - row}, of_pixel);
    }
}

// Gives every pixel its fragments.
std::vector<PixelCapture> Renderer::sort_captures(std::vector<FragmentNode> nodes, glm::ivec2 lower_left,
                                                  glm::ivec2 extent, bool has_transmittance) const {
    PixelCapture empty;
    empty.ray.warp = warp_;
    empty.ray.near_plane = NEAR_PLANE;
    empty.ray.far_plane = FAR_PLANE;
    std::vector<PixelCapture> captures(static_cast<std::size_t>(extent.x * extent.y), empty);
    const auto index_of = [&](int x, int y) {  // of a GL pixel
        return static_cast<std::size_t>((extent.y - 1 - (y - lower_left.y)) * extent.x + x - lower_left.x);
    };
    for (const FragmentNode& node : in_submission_order(std::move(nodes))) {
        PixelCapture& capture =
            captures[index_of(static_cast<int>(node.pixel & 0xffffU), static_cast<int>(node.pixel >> 16))];
        capture.ray.fragments.push_back(fragment_of(node, *buffers_));
        if (has_transmittance) capture.transmittance.push_back(node.transmittance);
    }
    std::vector<glm::vec4> behind(captures.size());
    glGetTextureSubImage(opaque_color_, 0, lower_left.x, lower_left.y, 0, extent.x, extent.y, 1, GL_RGBA,
                         GL_FLOAT, static_cast<GLsizei>(behind.size() * sizeof(glm::vec4)), behind.data());
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const glm::ivec2 at(static_cast<int>(i) % extent.x, static_cast<int>(i) / extent.x);
        captures[index_of(lower_left.x + at.x, lower_left.y + at.y)].behind = glm::vec3(behind[i]);
    }
    const std::vector<MomentVector> stored = transparency_->read_moments(lower_left, extent);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const glm::ivec2 at(static_cast<int>(i) % extent.x, static_cast<int>(i) / extent.x);
        captures[index_of(lower_left.x + at.x, lower_left.y + at.y)].stored = stored[i];
    }
    return captures;
}

}  // namespace momentscope
