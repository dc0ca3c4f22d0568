#include "ui/picture/scene_loader.hpp"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "core/render/scene_size.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/memory.hpp"

namespace momentscope::ui {

void SceneLoader::start(const std::string& id_or_path, float opacity) {
    assert(!busy());
    name_ = id_or_path;
    drawing_is_told_ = false;
    tell("");
    started_ = std::chrono::steady_clock::now();
    work_.start([this, id_or_path, opacity](const std::stop_token& stop, const auto&) {
        Scene scene = load_scene(id_or_path, opacity, stop, [this](const std::string& what) { tell(what); });
        scene.id = id_or_path;
        const SceneSize size = size_of(scene);
        tell(fmt::format("drawing {} triangles, which take {} of graphics memory", size.indices / 3,
                         memory_text(size.bytes())));
        return scene;
    });
}

std::optional<Scene> SceneLoader::take() {
    if (!work_.finished() || !std::exchange(drawing_is_told_, true)) return std::nullopt;
    return work_.take();
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
