#include "ui/picture/draft_picture.hpp"

#include <algorithm>
#include <chrono>

#include "core/scene/coarse_mesh.hpp"

namespace momentscope::ui {

namespace {

constexpr int MIN_DIVISOR = 2, MAX_DIVISOR = 4;

Sliced<std::vector<Mesh>> coarse_meshes(std::vector<Mesh> meshes, std::stop_token stop) {
    co_await Parts(
        meshes.size(), [&](std::size_t i) { meshes[i] = coarse_mesh(std::move(meshes[i])); }, stop);
    co_return std::move(meshes);
}

}  // namespace

void DraftPicture::set_scene(const Scene& scene) {
    coarse_meshes_.discard();
    is_coarse_ = false;
    scene_ = scene;
    scene_stale_ = true;
    divisor_ = MIN_DIVISOR;
}

void DraftPicture::set_objects(const std::vector<Object>& objects) {
    scene_.objects = objects;
    scene_stale_ = true;
}

void DraftPicture::use_coarse_meshes() {
    if (is_coarse_) return;
    if (!coarse_meshes_.busy())
        coarse_meshes_.start([meshes = scene_.meshes](const std::stop_token& stop, const auto&) {
            return coarse_meshes(meshes, stop);
        });
    std::optional<std::vector<Mesh>> meshes = coarse_meshes_.take();
    if (!meshes) return;
    scene_.meshes = *std::move(meshes);
    is_coarse_ = scene_stale_ = true;
    divisor_ = MIN_DIVISOR;
}

void DraftPicture::draw(const View& view, double wanted) {
    const auto begin = std::chrono::steady_clock::now();
    if (renderer_ == nullptr) renderer_ = std::make_unique<Renderer>(programs_);
    use_coarse_meshes();
    const bool first = scene_stale_;
    if (scene_stale_) renderer_->set_scene(scene_);
    scene_stale_ = false;
    View draft = view;
    draft.size = size_ = glm::max(view.size / divisor_, glm::ivec2(1));
    renderer_->render(draft);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    // The first draft uploads the scene and compiles shaders, so its time does not predict the next one.
    if (!first && took.count() > wanted) divisor_ = std::min(divisor_ + 1, MAX_DIVISOR);
}

glm::ivec2 DraftPicture::pixel_at(glm::vec2 place) const {
    return glm::clamp(glm::ivec2(place * glm::vec2(size_)), glm::ivec2(0), size_ - 1);
}

PixelCapture DraftPicture::capture(glm::vec2 place) {
    return renderer_->capture_pixel(pixel_at(place));
}

std::optional<LightView> DraftPicture::light(glm::vec2 place, const PixelCapture& eye,
                                             std::optional<std::size_t> receiver) {
    return view_from_light(*renderer_, pixel_at(place), eye, receiver);
}

}  // namespace momentscope::ui
