// light_probe.hpp -- how the opaque surfaces of the last picture are lit.
#pragma once
#include <optional>

#include "core/render/drawn_picture.hpp"

namespace momentscope {

/// The opaque surface in a pixel.
struct LitSurface {
    float view_depth = 0;
    float shadowed = 0;       // share of the filter region with an opaque caster in front
    float transmittance = 1;  // of the transparent casters in front
};

/// Belongs to one picture; make a new one when the picture changes.
class LightProbe {
public:
    /// depth: the texture of the picture's opaque depths. The picture must have shadows.
    LightProbe(const DrawnPicture& picture, GLuint depth);

    /// nullopt if the pixel shows no opaque surface.
    std::optional<LitSurface> surface(glm::ivec2 pixel) const;

private:
    glm::ivec2 size_;
    GlTexture probe_;
    GlFramebuffer target_;
};

}  // namespace momentscope
