// draft_picture.hpp -- the picture at a reduced resolution, for as long as a control moves.
#pragma once
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

    /// Draws a view at a fraction of its size in each direction: a half at first, less while drafts take
    /// longer than `wanted` milliseconds. Throws Error when the GL fails.
    void draw(const View& view, double wanted);

    /// Exact fragments of the draft's pixel at that place, a fraction of the picture.
    PixelCapture capture(glm::vec2 place);

    /// What lights that place; `eye` is its capture.
    std::optional<LightView> light(glm::vec2 place, const PixelCapture& eye,
                                   std::optional<std::size_t> receiver);

    GLuint display_texture() const { return renderer_->display_texture(); }

private:
    glm::ivec2 pixel_at(glm::vec2 place) const;

    std::shared_ptr<ProgramCache> programs_;
    std::unique_ptr<Renderer> renderer_;  // made when it is first asked for
    Scene scene_;
    bool scene_stale_ = true;
    int divisor_ = 2;
    glm::ivec2 size_{0};
};

}  // namespace momentscope::ui
