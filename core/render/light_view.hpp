// light_view.hpp -- the function of depth between the light and a receiver, instead of the one behind a
// pixel.
#pragma once
#include <limits>
#include <optional>
#include <string>

#include "core/render/renderer.hpp"
#include "core/shadow/light_breakdown.hpp"

namespace momentscope {

/// As a receiver: the opaque surface of the pixel, whatever lies in front of it.
constexpr std::size_t OPAQUE_SURFACE = std::numeric_limits<std::size_t>::max();

/// What the maps of the light hold for a receiver, prepared for the plot.
struct LightView {
    std::optional<std::size_t> fragment;  // of the view ray that receives light; nullopt: the opaque surface
    std::string receiver;                 // the receiver in words
    glm::vec3 world{0};                   // place of the receiver
    ShadowFilterSamples bundle;
    ViewRay ray;                  // of transparent casters: the mixture of all texels of the filter region
    ViewRay opaque;               // of opaque casters: A(z) is the share of the filter region in front of z
    Configuration configuration;  // of the map of transparent casters; beta is that of the light
    LightBreakdown breakdown;
    double visibility = 1;  // share of the light that reaches it, as the GL computes it
};

/// The receiver of a pixel of the last picture, which must have shadows. `receiver`: an index into
/// eye.ray.fragments or OPAQUE_SURFACE. If it is nullopt or does not exist, the receiver is what is mainly
/// seen in the pixel: the fragment at which the transmittance falls to one half; without one, the opaque
/// surface; without this, the farthest fragment. nullopt if the pixel shows nothing that could receive light.
std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> receiver);

}  // namespace momentscope
