#include "core/render/fragment_capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/low_footprint.hpp"
#include "core/scene/camera.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

struct CaptureVariant {
    ShaderVariant variant;
    bool has_transmittance;
};

CaptureVariant capture_variant(const DrawnPicture& picture) {
    std::optional<ShaderVariant> reconstructing =
        picture.transparency.bind_for_capture(picture.input.parameters);
    ShaderVariant variant = reconstructing.value_or(ShaderVariant());
    if (reconstructing) variant.defines["WITH_TRANSMITTANCE"] = "1";
    return {picture.input.lit(variant), reconstructing.has_value()};
}

// Captures the fragments of low-resolution pixels, from which low-resolution moments are made.
void add_shares(std::vector<PixelCapture>& captures, const DrawnPicture& picture,
                const Transparency::LowTarget& low, glm::ivec2 lower_left, glm::ivec2 extent) {
    const LowFootprint footprint(picture.view.size, low.size, lower_left, extent);
    const auto source =
        make_fragment_source(low.size, PIXEL_LIST_CAPACITY, low.depth, picture.input.programs.gl());
    set_viewport(low.size);
    std::vector<std::vector<Fragment>> of_pixel;
    for (int y = 0; y < footprint.extent().y; ++y) {  // row by row, so that the fragments fit in the list
        const auto nodes = source->capture(
            picture.input, {}, {footprint.corner() + glm::ivec2(0, y), {footprint.extent().x, 1}});
        if (!nodes)
            throw Error(
                "A row of low-resolution moments has more fragments than can be captured; choose a smaller picture.");
        of_pixel.resize(of_pixel.size() + static_cast<std::size_t>(footprint.extent().x));
        for (const FragmentNode& node : *nodes) {
            const int x = static_cast<int>(node.pixel & 0xffffU) - footprint.corner().x;
            of_pixel[of_pixel.size() - static_cast<std::size_t>(footprint.extent().x - x)].push_back(
                fragment_of(node, picture.input.scene));
        }
    }
    set_viewport(picture.view.size);
    for (std::size_t i = 0; i < captures.size(); ++i) {
        const int column = static_cast<int>(i) % extent.x, row = static_cast<int>(i) / extent.x;
        captures[i].ray.low_resolution_sources =
            footprint.shares_of({lower_left.x + column, lower_left.y + extent.y - 1 - row}, of_pixel);
    }
}

// Distributes fragments to their pixels.
std::vector<PixelCapture> sort_captures(const DrawnPicture& picture, const std::vector<FragmentNode>& nodes,
                                        glm::ivec2 lower_left, glm::ivec2 extent, bool has_transmittance) {
    PixelCapture empty;
    empty.ray.warp = picture.warp;
    empty.ray.near_plane = NEAR_PLANE;
    empty.ray.far_plane = FAR_PLANE;
    std::vector<PixelCapture> captures(static_cast<std::size_t>(extent.x * extent.y), empty);
    const auto index_of = [&](int x, int y) {  // of a GL pixel
        return static_cast<std::size_t>((extent.y - 1 - (y - lower_left.y)) * extent.x + x - lower_left.x);
    };
    for (const FragmentNode& node : nodes) {
        PixelCapture& capture =
            captures[index_of(static_cast<int>(node.pixel & 0xffffU), static_cast<int>(node.pixel >> 16))];
        capture.ray.fragments.push_back(fragment_of(node, picture.input.scene));
        if (has_transmittance) capture.transmittance.push_back(node.transmittance);
    }
    const std::vector<glm::vec4> behind = read_colors(picture.input.opaque_color, {lower_left, extent});
    for (std::size_t i = 0; i < captures.size(); ++i) {
        const glm::ivec2 at(static_cast<int>(i) % extent.x, static_cast<int>(i) / extent.x);
        captures[index_of(lower_left.x + at.x, lower_left.y + at.y)].behind = glm::vec3(behind[i]);
    }
    const std::vector<MomentVector> stored = picture.transparency.read_moments({lower_left, extent});
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const glm::ivec2 at(static_cast<int>(i) % extent.x, static_cast<int>(i) / extent.x);
        captures[index_of(lower_left.x + at.x, lower_left.y + at.y)].stored = stored[i];
    }
    return captures;
}

}  // namespace

FragmentCapture::FragmentCapture(glm::ivec2 size, GLuint depth, const Capabilities& gl)
    : size_(size), depth_(depth), gl_(gl) {}

FragmentSource& FragmentCapture::source() {
    if (source_ == nullptr) source_ = make_fragment_source(size_, PIXEL_LIST_CAPACITY, depth_, gl_);
    return *source_;
}

std::vector<PixelCapture> FragmentCapture::region(const DrawnPicture& picture, glm::ivec2 corner,
                                                  glm::ivec2 extent) {
    const auto [variant, has_transmittance] = capture_variant(picture);
    picture.bind();
    const glm::ivec2 lower_left(corner.x, picture.view.size.y - corner.y - extent.y);
    const auto nodes = source().capture(picture.input, variant, {lower_left, extent});
    if (!nodes && extent.x * extent.y > 1) {  // then capture two halves
        const bool rows = extent.y > 1;
        const glm::ivec2 half = rows ? glm::ivec2(extent.x, extent.y / 2) : glm::ivec2(extent.x / 2, 1);
        const glm::ivec2 step = rows ? glm::ivec2(0, half.y) : glm::ivec2(half.x, 0);
        std::vector<PixelCapture> captures = region(picture, corner, half);
        std::ranges::move(region(picture, corner + step, extent - step), std::back_inserter(captures));
        return captures;
    }
    if (!nodes)
        throw Error("A pixel has more transparent fragments than can be captured; simplify the scene.");
    std::vector<PixelCapture> captures =
        sort_captures(picture, *nodes, lower_left, extent, has_transmittance);
    if (const auto low = picture.transparency.low_target())
        add_shares(captures, picture, *low, lower_left, extent);
    leave_nothing_bound();
    check_gl("capturing pixels");
    return captures;
}

std::vector<float> FragmentCapture::lights(const DrawnPicture& picture, glm::ivec2 pixel) {
    assert(picture.shadows != nullptr && "the picture has no shadows");
    ShaderVariant variant = picture.input.lit({});
    variant.defines["WITH_LIGHT"] = "1";
    picture.bind();
    const glm::ivec2 lower_left(pixel.x, picture.view.size.y - 1 - pixel.y);
    const auto nodes = source().capture(picture.input, variant, {lower_left, {1, 1}});
    if (!nodes)
        throw Error("A pixel has more transparent fragments than can be captured; simplify the scene.");
    const std::vector<PixelCapture> captures = sort_captures(picture, *nodes, lower_left, {1, 1}, true);
    leave_nothing_bound();
    check_gl("reading how fragments are lit");
    return captures.front().transmittance;
}

}  // namespace momentscope
