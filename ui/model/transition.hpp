// transition.hpp -- moves one state into another, so that a lecture shows what changes.
#pragma once
#include "ui/model/state.hpp"

namespace momentscope::ui {

/// The state that is `share` of the way from one to another, share in [0, 1]: numbers of parameters, the
/// query depth, fragments of rays of equal length, the camera and the picked pixel move; everything else is
/// that of `to`.
ExplorerState between(const ExplorerState& from, const ExplorerState& to, float share);

/// A move that takes a while.
struct Transition {
    ExplorerState from, to;
    ExplorerState last;  // as it was shown last; if the user changes it, the move ends
    float seconds = 0;   // since its begin
};
constexpr float TRANSITION_SECONDS = 0.6f;

}  // namespace momentscope::ui
