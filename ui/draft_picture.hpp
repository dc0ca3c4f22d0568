// draft_picture.hpp -- the picture at a reduced resolution and with fewer triangles, for as long as a control
// moves.
#pragma once
#include <future>
#include <memory>

#include "core/render/light_view.hpp"

namespace momentscope::ui {

/// Has a renderer of its own, so that the full picture keeps its passes and is redrawn from the first stale
/// one alone.
class DraftPicture {
public:
    explicit DraftPicture(std::shared_ptr<ProgramCache> programs) : programs_(std::move(programs)) {}

    /// Another scene; drawn from the next `draw` on.
    void set_scene(const Scene& scene);

    /// Other objects of the same meshes.
    void set_objects(const std::vector<Object>& objects);

    /// Draws a view at a fraction of its size in each direction: a half at first, less while drafts take
    /// longer than `wanted` milliseconds. Coarse meshes (coarse_mesh.hpp) are made beside the first drafts,
    /// which show the full ones. Throws Error when the GL fails.
    void draw(const View& view, double wanted);

    /// Fragments of the draft's pixel at that place, a fraction of the picture, of the meshes that it shows.
    PixelCapture capture(glm::vec2 place);

    /// What lights that place; `eye` is its capture.
    std::optional<LightView> light(glm::vec2 place, const PixelCapture& eye,
                                   std::optional<std::size_t> receiver);

    GLuint display_texture() const { return renderer_->display_texture(); }

private:
    glm::ivec2 pixel_at(glm::vec2 place) const;
    void use_coarse_meshes();

    std::shared_ptr<ProgramCache> programs_;
    std::unique_ptr<Renderer> renderer_;  // made when it is first asked for
    Scene scene_;
    std::future<std::vector<Mesh>> coarse_meshes_;  // of the scene, until they are there
    bool is_coarse_ = false;
    bool scene_stale_ = true;
    int divisor_ = 2;
    glm::ivec2 size_{0};
};

}  // namespace momentscope::ui
