// scene_buffers.hpp -- a scene on the GPU.
#pragma once
#include <limits>
#include <vector>

#include "core/gl/handle.hpp"
#include "core/ray/submission_order.hpp"
#include "core/render/uniform_blocks.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

enum class Surfaces { opaque, transparent, opaque_casters };

/// Some of the triangles of surfaces, counted in submission order.
struct TriangleRange {
    std::size_t first = 0;
    std::size_t count = std::numeric_limits<std::size_t>::max();  // or as many as there are
};

/// Vertex, index and uniform buffers and alpha maps of one scene. Only the order of submission can change.
class SceneBuffers {
public:
    /// Throws Error if the scene is too large, before it takes memory, and if graphics memory runs out.
    explicit SceneBuffers(const Scene& scene);

    /// Sets the order of the objects and of the triangles of each: as in the scene, backwards, or shuffled.
    void set_order(const SubmissionOrder& order);

    /// The index in Scene::objects of the object that this draw call draws.
    std::uint32_t object_of_draw(std::uint32_t draw) const { return sequence_[draw]; }

    bool has_alpha_maps() const { return !alpha_maps_.empty(); }

    /// Draws the opaque objects, the transparent objects, or those opaque objects that cast shadows, in
    /// submission order with the program in use, or some of their triangles.
    void draw(Surfaces surfaces, TriangleRange triangles = {}) const;

    std::size_t triangle_count(Surfaces surfaces) const;

private:
    struct MeshBuffers {
        GlBuffer vertices, indices;
        GlVertexArray array;
        std::vector<std::uint32_t> submitted;  // indices in the order of the scene
    };
    bool belongs(std::size_t object, Surfaces surfaces) const;
    static MeshBuffers upload(const Mesh& mesh);
    std::vector<ObjectBlock> object_blocks() const;

    std::vector<MeshBuffers> meshes_;
    std::vector<Object> objects_;
    std::vector<std::uint32_t> sequence_;  // objects in submission order
    SubmissionOrder order_;
    GlBuffer object_blocks_;
    std::vector<GlTexture> alpha_maps_;
    GlTexture no_alpha_map_;  // one white texel
};

}  // namespace momentscope
