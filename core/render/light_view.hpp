// light_view.hpp -- the function behind a point that receives light, instead of the one behind a pixel.
#pragma once
#include <optional>

#include "core/render/renderer.hpp"
#include "core/shadow/light_verdict.hpp"

namespace momentscope {

/// What the light's map knows of a receiver, ready to be plotted.
struct LightView {
    std::optional<std::size_t> fragment;  // of the pixel that receives; nullopt: its opaque surface
    LightBundle bundle;
    ViewRay ray;                  // the mixture of all texels of the filter region
    Configuration configuration;  // of the map; beta is the light's
    LightVerdict verdict;
    double visibility = 1;  // the share of the light that the shading lets reach it, as the GL computes it
};

/// Of a pixel of the renderer's last picture, which must have shadows. `fragment`: which of eye.ray.fragments
/// receives; nullopt or one that is not there: the opaque surface, and where there is none the nearest
/// fragment. nullopt where a pixel shows nothing that could receive.
std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> fragment);

}  // namespace momentscope
