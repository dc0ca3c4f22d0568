// shown_scene.hpp -- the scene that is shown, and the reading of the next one.
#pragma once
#include <optional>
#include <string>

#include "ui/model/state.hpp"
#include "ui/model/status.hpp"
#include "ui/picture/scene_loader.hpp"

namespace momentscope::ui {

class ShownScene {
public:
    /// Is a mesh file being read? The shown scene stays until then.
    bool is_reading() const { return loader_.busy(); }
    void cancel_reading() { loader_.cancel(); }
    std::optional<Status::Progress> progress() const;

    /// The scene that was read, once it is there. Throws the Error of a file that cannot be used.
    std::optional<Scene> take_read() { return loader_.take(); }

    /// The scene of the state if it is not the shown one. For a mesh file it only starts the
    /// reading and returns nullopt. Throws Error
    /// if there is no such scene.
    std::optional<Scene> take_wanted(const ExplorerState& state);

    void show(Scene scene);
    bool shows_nothing() const { return scene_.id.empty(); }
    const Scene& scene() const { return scene_; }

    /// Which parts of the scene are missing; "" if none is.
    std::string warning() const;

    /// Gives the objects of a mesh file the opacity of the state. Returns true if this changed the scene.
    /// Opacity is a parameter of mesh files only; built-in scenes have their own opacities.
    bool apply_opacity(const ExplorerState& state);

    /// The default distance of its light.
    float light_distance() const { return light_distance_; }

    Camera camera(const ExplorerState& state) const { return state.camera.value_or(scene_.camera); }

private:
    SceneLoader loader_;
    Scene scene_;
    float light_distance_ = 1;
};

}  // namespace momentscope::ui
