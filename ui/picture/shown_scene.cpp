#include "ui/picture/shown_scene.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/scene/scenes.hpp"
#include "core/shadow/light_camera.hpp"

namespace momentscope::ui {

std::optional<Status::Progress> ShownScene::progress() const {
    if (!loader_.busy()) return std::nullopt;
    return Status::Progress{loader_.name(), loader_.stage(), loader_.seconds()};
}

std::optional<Scene> ShownScene::take_wanted(const ExplorerState& state) {
    if (state.scene == scene_.id) return std::nullopt;
    const float opacity = state.parameters.number(ParameterId::opacity);
    if (is_builtin_scene(state.scene)) return load_scene(state.scene, opacity);
    loader_.start(state.scene, opacity);
    return std::nullopt;
}

void ShownScene::show(Scene scene) {
    scene_ = std::move(scene);
    light_distance_ = standard_light_distance(caster_bounds(scene_));
}

std::string ShownScene::warning() const {
    return fmt::format("{}", fmt::join(scene_.warnings, " "));
}

bool ShownScene::apply_opacity(const ExplorerState& state) {
    if (is_builtin_scene(scene_.id)) return false;
    const float opacity = state.parameters.number(ParameterId::opacity);
    bool changed = false;
    for (Object& object : scene_.objects) {
        if (object.opaque() || object.opacity == opacity) continue;
        object.opacity = opacity;
        changed = true;
    }
    return changed;
}

}  // namespace momentscope::ui
