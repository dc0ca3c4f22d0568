// stress_run.hpp -- tests techniques under difficult conditions in the background; the Stress tab.
#pragma once
#include <string>
#include <vector>

#include "core/stress/stress.hpp"
#include "core/support/background_work.hpp"
#include "ui/model/state.hpp"
#include "ui/model/status.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

class StressRun {
public:
    /// Takes the cells of a finished run. Call it once per frame, whichever tab is open.
    void poll();

    /// Draws the tab. A click on a cell opens its worst ray in the editor.
    void draw(const Ui& ui, ExplorerState& state, Status& status);

    bool busy() const { return work_.busy(); }
    const std::vector<StressCell>& cells() const { return cells_; }

private:
    void start(const ExplorerState& state);
    void draw_progress(const Ui& ui);
    void open_worst(const StressCell& cell, ExplorerState& state, Status& status);

    int rays_ = 100;
    std::vector<StressCell> cells_;
    std::string title_;  // of the cells
    BackgroundWork<std::vector<StressCell>> work_;
};

}  // namespace momentscope::ui
