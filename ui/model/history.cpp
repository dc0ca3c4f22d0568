#include "ui/model/history.hpp"

#include <cassert>
#include <utility>

namespace momentscope::ui {

namespace {

constexpr std::size_t MAX_STEPS = 1000;  // a state is small, and a long lesson takes a few hundred steps

}  // namespace

void History::record(const ExplorerState& state) {
    if (state == present_) return;
    past_.push_back(std::exchange(present_, state));
    if (past_.size() > MAX_STEPS) past_.erase(past_.begin());
    future_.clear();
}

void History::reject_present(const ExplorerState& shown) {
    if (!future_.empty() && future_.back() == shown)
        future_.pop_back();  // it was reached by undo
    else if (!past_.empty() && past_.back() == shown)
        past_.pop_back();
    present_ = shown;
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
