#include "core/render/shadow_capture.hpp"

#include <array>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"
#include "core/shadow/shadow_filter.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

struct CaptureInput {
    CasterTexels& texels;
    const SceneBuffers& scene;
    GLuint frame_block;
    const ShadowMapTextures& maps;
    const ShadowSettings& settings;
};

// Captures the fragments and the opaque depth of each texel of the region.
void capture_region(const CaptureInput& in, ShadowFilterSamples& bundle) {
    const ShadowFootprint region = shadow_footprint(bundle.place.texel, in.settings.size, in.settings.radius);
    for (const float weight : region.weights) bundle.texels.push_back({weight, {}});
    auto nodes = in.settings.casters
                     ? in.texels.capture(in.scene, in.frame_block, {region.corner, region.extent})
                     : std::vector<FragmentNode>();
    if (!nodes)
        throw Error(
            "Too many fragments lie between this receiver and the light; choose a smaller --shadow-radius or a greater "
            "--shadow-size.");
    for (const FragmentNode& node : *nodes) {
        const glm::ivec2 at =
            glm::ivec2(static_cast<int>(node.pixel & 0xffffU), static_cast<int>(node.pixel >> 16U)) -
            region.corner;
        bundle.texels[static_cast<std::size_t>(at.y * region.extent.x + at.x)].fragments.push_back(
            fragment_of(node, in.scene));
    }
    const std::vector<float> depths = read_texture(in.maps.nearest, {region.corner, region.extent}, 1);
    for (std::size_t i = 0; i < depths.size(); ++i) bundle.opaque.push_back({depths[i], region.weights[i]});
}

// Reads the four filtered texels that are interpolated, which are those of a filter with radius 0.
void read_filtered(const CaptureInput& in, ShadowFilterSamples& bundle) {
    const ShadowFootprint corners = shadow_footprint(bundle.place.texel, in.settings.size, 0);
    bundle.sums.assign(4 * in.maps.layers, 0.0f);
    for (std::size_t i = 0; i < corners.weights.size(); ++i) {
        const glm::ivec2 at = corners.corner + glm::ivec2(static_cast<int>(i) % corners.extent.x,
                                                          static_cast<int>(i) / corners.extent.x);
        const TexelRect texel = {at, {1, 1}};
        const auto add = [&](const glm::vec4& values, float* sum) {
            for (int k = 0; k < 4; ++k) sum[k] += corners.weights[i] * values[k];
        };
        for (std::size_t layer = 0; layer < in.maps.layers; ++layer)
            add(read_layer_colors(in.maps.filtered, static_cast<int>(layer), texel).front(),
                &bundle.sums[4 * layer]);
        if (in.maps.opaque_filtered != 0)
            add(read_colors(in.maps.opaque_filtered, texel).front(), bundle.texel.data());
    }
    if (!bundle.sums.empty())
        bundle.sums.resize(static_cast<std::size_t>(texel_numbers(in.settings.transparent)));
}

}  // namespace

ShadowFilterSamples capture_filter_region(CasterTexels& texels, const SceneBuffers& scene, GLuint frame_block,
                                          const ShadowMapTextures& maps, const LightCamera& frame,
                                          const ShadowSettings& settings, const ShadowMapPosition& place) {
    ShadowFilterSamples bundle;
    bundle.place = place;
    bundle.warp = frame.warp;
    bundle.near_plane = frame.near_plane;
    bundle.far_plane = frame.far_plane;
    if (!place.within) return bundle;
    const CaptureInput in = {texels, scene, frame_block, maps, settings};
    capture_region(in, bundle);
    read_filtered(in, bundle);
    leave_nothing_bound();
    check_gl("capturing the light's rays");
    return bundle;
}

}  // namespace momentscope
