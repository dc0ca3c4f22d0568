// renderer_capture.cpp -- captures the exact fragments of pixels of the last picture.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/error.hpp"
#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/low_footprint.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/camera.hpp"

namespace momentscope {

GLuint Renderer::capture_program(bool& has_transmittance) {
    std::optional<ShaderVariant> reconstructing = transparency_->bind_for_capture(parameters_);
    has_transmittance = reconstructing.has_value();
    ShaderVariant variant = reconstructing.value_or(ShaderVariant());
    if (has_transmittance) variant.defines["WITH_TRANSMITTANCE"] = "1";
    return programs_->get("passes/scene.vert", "passes/capture.frag", pass_input().lit(variant));
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
    if (lit()) shadow_maps_->bind(view_matrix(view_.camera));
    const glm::ivec2 lower_left(corner.x, view_.size.y - corner.y - extent.y);
    const std::size_t count = pixel_list_->capture(pass_input(), program, lower_left, extent);
    if (count > pixel_list_->capacity() && extent.x * extent.y > 1) {  // then capture two halves
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

// Captures the fragments of low-resolution pixels, from which low-resolution moments are made.
void Renderer::add_shares(std::vector<PixelCapture>& captures, const Transparency::LowTarget& low,
                          glm::ivec2 lower_left, glm::ivec2 extent) {
    const LowFootprint footprint(view_.size, low.size, lower_left, extent);
    FragmentList list(low.size, PIXEL_LIST_CAPACITY, low.depth);
    glViewport(0, 0, low.size.x, low.size.y);
    const GLuint program = programs_->get("passes/scene.vert", "passes/capture.frag");
    std::vector<std::vector<Fragment>> of_pixel;
    for (int y = 0; y < footprint.extent().y; ++y) {  // row by row, so that the fragments fit in the list
        const std::size_t count = list.capture(pass_input(), program, footprint.corner() + glm::ivec2(0, y),
                                               {footprint.extent().x, 1});
        if (count > list.capacity())
            throw Error(
                fmt::format("A row of low-resolution moments has {} fragments, but at most {} can be "
                            "captured; choose a smaller picture.",
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
        captures[i].ray.low_resolution_sources =
            footprint.shares_of({lower_left.x + column, lower_left.y + extent.y - 1 - row}, of_pixel);
    }
}

// Distributes fragments to their pixels.
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
