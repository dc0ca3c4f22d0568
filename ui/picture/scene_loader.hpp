// scene_loader.hpp -- reads a mesh file in a thread, so that the window stays responsive.
#pragma once
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "core/scene/scene.hpp"
#include "core/support/background_work.hpp"

namespace momentscope::ui {

class SceneLoader {
public:
    /// Call this only if not busy.
    void start(const std::string& id_or_path, float opacity);
    bool busy() const { return work_.busy(); }
    void cancel() { work_.cancel(); }

    /// The scene once it is read, nullopt before. A read scene is held back for one more frame, so that this
    /// frame can announce the drawing, which may take longer. Throws the Error of a file that cannot be used.
    std::optional<Scene> take();

    const std::string& name() const { return name_; }
    double seconds() const;

    /// The current step, such as "placing its triangles".
    std::string stage() const;

private:
    void tell(const std::string& what);

    std::string name_;
    mutable std::mutex mutex_;
    std::string stage_;  // protected by the mutex
    bool drawing_is_told_ = false;
    std::chrono::steady_clock::time_point started_;
    BackgroundWork<Scene> work_;  // declared last: it uses the rest
};

}  // namespace momentscope::ui
