#include "ui/picture/scene_loader.hpp"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "core/render/scene_size.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/memory.hpp"

namespace momentscope::ui {

SceneLoader::~SceneLoader() {
    cancel();  // the future waits for its thread
}

void SceneLoader::start(const std::string& id_or_path, float opacity) {
    assert(!busy());
    name_ = id_or_path;
    stop_ = std::stop_source();
    drawing_is_told_ = false;
    tell("");
    started_ = std::chrono::steady_clock::now();
    result_ = std::async(std::launch::async, [this, id_or_path, opacity, stop = stop_.get_token()] {
        Scene scene = load_scene(id_or_path, opacity, stop, [this](const std::string& what) { tell(what); });
        scene.id = id_or_path;
        const SceneSize size = size_of(scene);
        tell(fmt::format("drawing {} triangles, which take {} of graphics memory", size.indices / 3,
                         memory_text(size.bytes())));
        return scene;
    });
}

std::optional<Scene> SceneLoader::take() {
    if (!busy() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    if (!std::exchange(drawing_is_told_, true)) return std::nullopt;
    return result_.get();  // makes the future invalid, so busy() is false, even if get() throws
}

void SceneLoader::tell(const std::string& what) {
    const std::scoped_lock lock(mutex_);
    stage_ = what;
}

std::string SceneLoader::stage() const {
    const std::scoped_lock lock(mutex_);
    return stage_;
}

double SceneLoader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

}  // namespace momentscope::ui
