// history.hpp -- undo and redo over values of the state.
#pragma once
#include <vector>

#include "ui/state.hpp"

namespace momentscope::ui {

class History {
public:
    explicit History(const ExplorerState& first) : present_(first) {}

    /// Makes a changed state a step that can be undone; the same state again is none. Forgets what was
    /// undone.
    void record(const ExplorerState& state);

    /// The present cannot be shown: goes back to the state that is, and forgets the step to the present.
    void reject_present(const ExplorerState& shown);

    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

    /// The state before or after. Call only when there is one.
    const ExplorerState& undo();
    const ExplorerState& redo();

    const ExplorerState& present() const { return present_; }

private:
    std::vector<ExplorerState> past_, future_;  // the last is the nearest
    ExplorerState present_;
};

}  // namespace momentscope::ui
