// scene_buffers.hpp -- a scene on the GPU.
#pragma once
#include <vector>

#include "core/gl/handle.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

enum class Surfaces { opaque, transparent };

/// Vertex, index and uniform buffers and alpha maps of one scene; immutable.
class SceneBuffers {
public:
    /// Throws Error when the scene is too large, before it takes memory, and when graphics memory runs out.
    explicit SceneBuffers(const Scene& scene);

    /// Draws the opaque or the transparent objects in submission order with the program in use. The index of
    /// an object in Scene::objects is its draw id.
    void draw(Surfaces surfaces) const;

private:
    struct MeshBuffers {
        GlBuffer vertices, indices;
        GlVertexArray array;
        GLsizei index_count = 0;
    };
    static MeshBuffers upload(const Mesh& mesh);

    std::vector<MeshBuffers> meshes_;
    std::vector<Object> objects_;
    GlBuffer object_blocks_;
    std::vector<GlTexture> alpha_maps_;
    GlTexture no_alpha_map_;  // one white texel
};

}  // namespace momentscope
