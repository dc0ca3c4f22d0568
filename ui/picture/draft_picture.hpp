// draft_picture.hpp -- the picture at a reduced resolution and with fewer triangles, while a control moves.
#pragma once
#include <memory>

#include "core/render/view_from_light.hpp"
#include "core/support/background_work.hpp"

namespace momentscope::ui {

/// Has a renderer of its own, so the full picture keeps its passes and continues from the first stale one.
class DraftPicture {
public:
    explicit DraftPicture(std::shared_ptr<ProgramCache> programs) : programs_(std::move(programs)) {}

    /// Sets another scene; the next `draw` shows it.
    void set_scene(const Scene& scene);

    /// Sets other objects of the same meshes.
    void set_objects(const std::vector<Object>& objects);

    /// Draws a view at a fraction of its size in each direction: a half at first, and less if drafts take
    /// longer than `wanted` milliseconds. Coarse meshes (coarse_mesh.hpp) are computed in a thread; drafts
    /// use the full meshes until then. Throws Error if the GL fails.
    void draw(const View& view, double wanted);

    /// The fragments of the draft's pixel at this place (a fraction of the picture), from the meshes of the
    /// draft.
    PixelCapture capture(glm::vec2 place);

    /// The light at this place; `eye` is its capture.
    std::optional<LightView> light(glm::vec2 place, const PixelCapture& eye,
                                   std::optional<std::size_t> receiver);

    GLuint display_texture() const { return renderer_->display_texture(); }

private:
    glm::ivec2 pixel_at(glm::vec2 place) const;
    void use_coarse_meshes();

    std::shared_ptr<ProgramCache> programs_;
    std::unique_ptr<Renderer> renderer_;  // created on first use
    Scene scene_;
    BackgroundWork<std::vector<Mesh>> coarse_meshes_;  // of the scene
    bool is_coarse_ = false;
    bool scene_stale_ = true;
    int divisor_ = 2;
    glm::ivec2 size_{0};
};

}  // namespace momentscope::ui
