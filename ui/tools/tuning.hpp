// tuning.hpp -- the button that searches for the best parameters in the background.
#pragma once
#include <optional>

#include "core/render/renderer.hpp"
#include "core/stress/tune.hpp"
#include "core/support/background_work.hpp"
#include "ui/model/state.hpp"
#include "ui/model/status.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

class Tuning {
public:
    /// Searches over the ray of the state, or over pixels of the scene.
    void start(const ExplorerState& state, const Scene& scene, const Renderer& renderer, Status& status);

    /// Applies a finished result. Call it once per frame, whichever tab is open.
    void poll(ExplorerState& state, Status& status);

    /// Draws the button, or the progress of the search. Returns true if a search was requested.
    bool draw(const Ui& ui, const ExplorerState& state);

    bool busy() const { return work_.busy(); }

private:
    BackgroundWork<std::optional<TuneResult>> work_;
    const Technique* technique_ = nullptr;  // that the search is for
};

}  // namespace momentscope::ui
