// reference_picture.hpp -- the same scene, drawn with the technique that the picture is compared with.
#pragma once
#include <memory>

#include "core/render/renderer.hpp"

namespace momentscope::ui {

class ReferencePicture {
public:
    /// The scene has changed; the next picture is drawn from the start.
    void forget() { renderer_.reset(); }

    /// The first stage that a picture of this view would run.
    Stage stale_stage(const View& view) const;

    /// Returns true if anything was drawn. Throws Error if the view cannot be drawn.
    bool draw(const View& view, const Scene& scene, const std::shared_ptr<ProgramCache>& programs);

    /// Call these only after draw.
    GLuint texture() const { return renderer_->display_texture(); }
    Image picture() const { return renderer_->read_picture(); }
    Image region(glm::ivec2 corner, glm::ivec2 extent) const {
        return renderer_->read_region(corner, extent);
    }

private:
    std::unique_ptr<Renderer> renderer_;  // made at first use
    View view_;                           // the last one
};

}  // namespace momentscope::ui
