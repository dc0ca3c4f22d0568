#include "ui/scene_loader.hpp"

#include <cassert>

#include "core/scene/scenes.hpp"

namespace momentscope::ui {

SceneLoader::~SceneLoader() {
    cancel();  // the future waits for its thread
}

void SceneLoader::start(const std::string& id_or_path, float opacity) {
    assert(!busy());
    name_ = id_or_path;
    stop_ = std::stop_source();
    started_ = std::chrono::steady_clock::now();
    result_ = std::async(std::launch::async, [id_or_path, opacity, stop = stop_.get_token()] {
        Scene scene = load_scene(id_or_path, opacity, stop);
        scene.id = id_or_path;
        return scene;
    });
}

std::optional<Scene> SceneLoader::take() {
    if (!busy() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return result_.get();  // leaves the future without a state: not busy any more, even if it throws
}

double SceneLoader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

}  // namespace momentscope::ui
