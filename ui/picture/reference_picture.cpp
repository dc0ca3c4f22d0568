#include "ui/picture/reference_picture.hpp"

namespace momentscope::ui {

Stage ReferencePicture::stale_stage(const View& view) const {
    return renderer_ == nullptr ? Stage::opaque : first_stale_stage(view_, view);
}

bool ReferencePicture::draw(const View& view, const Scene& scene,
                            const std::shared_ptr<ProgramCache>& programs) {
    if (renderer_ == nullptr) {
        renderer_ = std::make_unique<Renderer>(programs);
        renderer_->set_scene(scene);
    }
    const int before = renderer_->pass_counts().composite;
    view_ = view;
    renderer_->render(view);
    return renderer_->pass_counts().composite > before;
}

}  // namespace momentscope::ui
