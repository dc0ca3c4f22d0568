// drawn_picture.hpp -- the last picture of a renderer, for passes that look at it once more.
#pragma once
#include "core/ray/view_ray.hpp"
#include "core/render/shadow_maps.hpp"
#include "core/render/transparency.hpp"
#include "core/render/view.hpp"

namespace momentscope {

/// Valid until the renderer draws again.
struct DrawnPicture {
    const View& view;
    PassInput input;
    Transparency& transparency;
    const DepthWarp& warp;
    GLuint frame_block;
    const ShadowMaps* shadows;  // null: the picture has no shadows

    /// Binds what geometry passes read, and sets the viewport to the picture.
    void bind() const;
};

}  // namespace momentscope
