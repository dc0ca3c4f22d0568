// scene_buffers.hpp -- a scene on the GPU.
#pragma once
#include <vector>

#include "core/gl/handle.hpp"
#include "core/ray/submission_order.hpp"
#include "core/render/uniform_blocks.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

enum class Surfaces { opaque, transparent, opaque_casters };

/// Vertex, index and uniform buffers and alpha maps of one scene; immutable.
class SceneBuffers {
public:
    /// Throws Error when the scene is too large, before it takes memory, and when graphics memory runs out.
    explicit SceneBuffers(const Scene& scene);

    /// The order of objects and of the triangles of each: as in the scene, backwards, or shuffled.
    void set_order(const SubmissionOrder& order);

    /// Which object, by its index in Scene::objects, is the draw call of that index.
    std::uint32_t object_of_draw(std::uint32_t draw) const { return sequence_[draw]; }

    bool has_alpha_maps() const { return !alpha_maps_.empty(); }

    /// Draws the opaque or the transparent objects, or of the former those that cast shadows, in submission
    /// order with the program in use.
    void draw(Surfaces surfaces) const;

private:
    struct MeshBuffers {
        GlBuffer vertices, indices;
        GlVertexArray array;
        std::vector<std::uint32_t> submitted;  // the indices as the scene has them
    };
    static MeshBuffers upload(const Mesh& mesh);
    std::vector<ObjectBlock> object_blocks() const;

    std::vector<MeshBuffers> meshes_;
    std::vector<Object> objects_;
    std::vector<std::uint32_t> sequence_;  // objects in the order of submission
    SubmissionOrder order_;
    GlBuffer object_blocks_;
    std::vector<GlTexture> alpha_maps_;
    GlTexture no_alpha_map_;  // one white texel
};

}  // namespace momentscope
