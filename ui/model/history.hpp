// history.hpp -- undo and redo over values of the state.
#pragma once
#include <vector>

#include "ui/model/state.hpp"

namespace momentscope::ui {

class History {
public:
    explicit History(const ExplorerState& first) : present_(first) {}

    /// Records a changed state as a step that can be undone, and discards the redo steps. An unchanged state
    /// is not recorded.
    void record(const ExplorerState& state);

    /// Call this if the present cannot be shown. Goes back to the state that is shown, and discards the step
    /// to the present.
    void reject_present(const ExplorerState& shown);

    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

    /// The previous or the next state. Call only if there is one.
    const ExplorerState& undo();
    const ExplorerState& redo();

private:
    std::vector<ExplorerState> past_, future_;  // the last element is the nearest step
    ExplorerState present_;
};

}  // namespace momentscope::ui
