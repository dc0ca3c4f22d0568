// peeled_fragments.hpp -- captures fragments layer by layer, on a GL whose shaders cannot write lists.
#pragma once
#include "core/gl/handle.hpp"
#include "core/render/fragment_list.hpp"

namespace momentscope {

/// The n-th pass keeps the n-th fragment of each pixel in submission order: the stencil counts the fragments
/// of a pixel while they are drawn, and the test passes the one with this number. So fragments at one depth
/// stay apart, and come in the order in which they were submitted.
class PeeledFragments : public FragmentSource {
public:
    /// size: of the picture. depth: the texture that fragments are compared with.
    PeeledFragments(glm::ivec2 size, GLuint depth, const Capabilities& gl);

    std::optional<std::vector<FragmentNode>> capture(const PassInput& input, const ShaderVariant& variant,
                                                     const TexelRect& rect) override;

private:
    bool capture_triangles(const SceneBuffers& scene, const TriangleRange& triangles, bool numbered,
                           const TexelRect& rect, std::vector<FragmentNode>& nodes) const;
    void read_layer(const TexelRect& rect, const std::vector<glm::vec4>& numbers,
                    std::vector<FragmentNode>& nodes) const;

    GLuint depth_;
    bool primitive_ids_;
    GlTexture color_, depths_, numbers_, count_;
    GlFramebuffer target_;
};

}  // namespace momentscope
