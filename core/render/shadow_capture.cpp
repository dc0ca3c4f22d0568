// shadow_capture.cpp -- captures the fragments and depths in the filter region of a receiver.
#include <array>

#include "core/error.hpp"
#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/render/shadow_maps.hpp"
#include "core/shadow/shadow_filter.hpp"

namespace momentscope {

// nullopt if there are more fragments than can be captured at a time. frame_block_ still holds the light as
// the eye, since the maps were drawn.
std::optional<std::vector<FragmentNode>> ShadowMaps::capture_texels(const SceneBuffers& scene,
                                                                    glm::ivec2 corner, glm::ivec2 extent) {
    constexpr std::size_t CAPACITY = 1'000'000;
    if (list_ == nullptr)
        list_ = std::make_unique<FragmentList>(glm::ivec2(settings_->size), CAPACITY, no_depth_);
    glViewport(0, 0, settings_->size, settings_->size);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block_);
    static const ResolvedParameters NONE;
    const PassInput input = {*programs_, scene, glm::ivec2(settings_->size), 0, no_depth_, NONE};
    const GLuint program = programs_->get("passes/scene.vert", "passes/capture.frag");
    const std::size_t count = list_->capture(input, program, corner, extent);
    if (count > list_->capacity()) return std::nullopt;
    return list_->read(count);
}

// Captures the fragments and the opaque depth of each texel of the region.
void ShadowMaps::capture_region(const SceneBuffers& scene, ShadowFilterSamples& bundle) {
    const ShadowFootprint region = shadow_footprint(bundle.place.texel, settings_->size, settings_->radius);
    for (const float weight : region.weights) bundle.texels.push_back({weight, {}});
    auto nodes = settings_->casters ? capture_texels(scene, region.corner, region.extent)
                                    : std::vector<FragmentNode>();
    if (!nodes)
        throw Error(
            "Too many fragments lie between this receiver and the light; choose a smaller --shadow-radius or a greater "
            "--shadow-size.");
    for (const FragmentNode& node : in_submission_order(std::move(*nodes))) {
        const glm::ivec2 at =
            glm::ivec2(static_cast<int>(node.pixel & 0xffffU), static_cast<int>(node.pixel >> 16U)) -
            region.corner;
        bundle.texels[static_cast<std::size_t>(at.y * region.extent.x + at.x)].fragments.push_back(
            fragment_of(node, scene));
    }
    std::vector<float> depths(region.weights.size());
    glGetTextureSubImage(nearest_, 0, region.corner.x, region.corner.y, 0, region.extent.x, region.extent.y,
                         1, GL_RED, GL_FLOAT, static_cast<GLsizei>(depths.size() * sizeof(float)),
                         depths.data());
    for (std::size_t i = 0; i < depths.size(); ++i) bundle.opaque.push_back({depths[i], region.weights[i]});
}

// Reads the four filtered texels that are interpolated, which are those of a filter with radius 0.
void ShadowMaps::read_filtered(ShadowFilterSamples& bundle) const {
    const ShadowFootprint corners = shadow_footprint(bundle.place.texel, settings_->size, 0);
    bundle.sums.assign(4 * filtered_targets_.size(), 0.0f);
    for (std::size_t i = 0; i < corners.weights.size(); ++i) {
        const glm::ivec2 at = corners.corner + glm::ivec2(static_cast<int>(i) % corners.extent.x,
                                                          static_cast<int>(i) / corners.extent.x);
        const auto add = [&](GLuint texture, int layer, float* sum) {
            std::array<float, 4> values{};
            glGetTextureSubImage(texture, 0, at.x, at.y, layer, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof(values),
                                 values.data());
            for (std::size_t k = 0; k < 4; ++k) sum[k] += corners.weights[i] * values[k];
        };
        for (std::size_t layer = 0; layer < filtered_targets_.size(); ++layer)
            add(filtered_, static_cast<int>(layer), &bundle.sums[4 * layer]);
        if (!settings_->opaque->unfiltered) add(opaque_filtered_, 0, bundle.texel.data());
    }
    if (!bundle.sums.empty())
        bundle.sums.resize(static_cast<std::size_t>(texel_numbers(settings_->transparent)));
}

ShadowFilterSamples ShadowMaps::capture(const SceneBuffers& scene, const ShadowMapPosition& place) {
    ShadowFilterSamples bundle;
    bundle.place = place;
    bundle.warp = frame_.warp;
    bundle.near_plane = frame_.near_plane;
    bundle.far_plane = frame_.far_plane;
    if (!place.within) return bundle;
    capture_region(scene, bundle);
    read_filtered(bundle);
    leave_nothing_bound();
    check_gl("capturing the light's rays");
    return bundle;
}

}  // namespace momentscope
