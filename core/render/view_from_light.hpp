// view_from_light.hpp -- captures what the light sees of a receiver in a pixel.
#pragma once
#include <optional>

#include "core/render/renderer.hpp"
#include "core/shadow/light_view.hpp"

namespace momentscope {

/// The receiver of a pixel of the last picture, which must have shadows. `receiver`: an index into
/// eye.ray.fragments or OPAQUE_SURFACE. If it is nullopt or does not exist, the receiver is what is mainly
/// seen in the pixel: the fragment at which the transmittance falls to one half; without one, the opaque
/// surface; without this, the farthest fragment. nullopt if the pixel shows nothing that could receive light.
std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> receiver);

}  // namespace momentscope
