// caster_texels.hpp -- captures the transparent casters in texels of the light's map.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/render/fragment_list.hpp"

namespace momentscope {

class CasterTexels {
public:
    /// size: texels of a side of the map.
    CasterTexels(int size, std::shared_ptr<ProgramCache> programs);

    /// The fragments of a rectangle of texels; nullopt if there are more than can be captured at a time.
    /// frame_block: the uniform block with the light as the eye.
    std::optional<std::vector<FragmentNode>> capture(const SceneBuffers& scene, GLuint frame_block,
                                                     const TexelRect& rect);

private:
    int size_;
    std::shared_ptr<ProgramCache> programs_;
    GlTexture no_depth_;                      // far everywhere, so every fragment passes
    std::unique_ptr<FragmentSource> source_;  // made at first use
};

}  // namespace momentscope
