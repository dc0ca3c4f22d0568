#include "ui/history.hpp"

#include <cassert>
#include <utility>

namespace momentscope::ui {

namespace {

constexpr std::size_t MOST_STEPS = 1000;  // a state is small; a long lesson has some hundred

}  // namespace

void History::record(const ExplorerState& state) {
    if (state == present_) return;
    past_.push_back(std::exchange(present_, state));
    if (past_.size() > MOST_STEPS) past_.erase(past_.begin());
    future_.clear();
}

const ExplorerState& History::undo() {
    assert(can_undo());
    future_.push_back(std::exchange(present_, past_.back()));
    past_.pop_back();
    return present_;
}

const ExplorerState& History::redo() {
    assert(can_redo());
    past_.push_back(std::exchange(present_, future_.back()));
    future_.pop_back();
    return present_;
}

}  // namespace momentscope::ui
