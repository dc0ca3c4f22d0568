// light_view.hpp -- the function of depth between the light and a receiver, instead of the one behind a
// pixel.
#pragma once
#include <limits>
#include <optional>
#include <string>

#include "core/shadow/light_breakdown.hpp"
#include "core/techniques/configuration.hpp"

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

}  // namespace momentscope
