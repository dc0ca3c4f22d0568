// light_view.hpp -- the function behind a point that receives light, instead of the one behind a pixel.
#pragma once
#include <limits>
#include <optional>
#include <string>

#include "core/render/renderer.hpp"
#include "core/shadow/light_breakdown.hpp"

namespace momentscope {

/// Of receivers: the pixel's opaque surface, whatever lies before it.
constexpr std::size_t OPAQUE_SURFACE = std::numeric_limits<std::size_t>::max();

/// What the light's maps know of a receiver, ready to be plotted.
struct LightView {
    std::optional<std::size_t>
        fragment;          // of the eye's ray, that receives; nullopt: the pixel's opaque surface
    std::string receiver;  // the same in words
    glm::vec3 world{0};    // where it is
    ShadowFilterSamples bundle;
    ViewRay ray;                  // transparent casters: the mixture of all texels of the filter region
    ViewRay opaque;               // opaque casters: A(z) is the share of the region in front of z
    Configuration configuration;  // of the transparent casters' map; beta is the light's
    LightBreakdown breakdown;
    double visibility = 1;  // the share of the light that the shading lets reach it, as the GL computes it
};

/// Of a pixel of the renderer's last picture, which must have shadows. `receiver`: one of eye.ray.fragments
/// or OPAQUE_SURFACE; nullopt or what is not there: what is seen of the pixel, which is the fragment with
/// which it is covered by half, else the opaque surface, else the farthest fragment. nullopt where a pixel
/// shows nothing that could receive.
std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> receiver);

}  // namespace momentscope
