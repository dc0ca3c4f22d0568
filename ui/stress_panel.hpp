// stress_panel.hpp -- the tab that tests techniques under difficult conditions.
#pragma once
#include <string>
#include <vector>

#include "core/stress/stress.hpp"
#include "core/support/background_work.hpp"
#include "ui/state.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

class StressPanel {
public:
    /// Takes the cells of a finished run. Call it once per frame, whichever tab is open.
    void poll();

    /// Draws the tab. A click on a cell opens its worst ray in the editor.
    void draw(const Ui& ui, ExplorerState& state, std::string& message);

    bool busy() const { return work_.busy(); }
    const std::vector<StressCell>& cells() const { return cells_; }

private:
    void start(const ExplorerState& state);
    void draw_progress(const Ui& ui);
    void open_worst(const StressCell& cell, ExplorerState& state, std::string& message);

    int rays_ = 100;
    std::vector<StressCell> cells_;
    std::string title_;  // of the cells
    BackgroundWork<std::vector<StressCell>> work_;
};

}  // namespace momentscope::ui
