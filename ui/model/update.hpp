// update.hpp -- one update of what the window shows.
#pragma once
#include "ui/model/frame_report.hpp"
#include "ui/model/state.hpp"
#include "ui/model/status.hpp"

namespace momentscope::ui {

/// From the state that is shown to the state that the user wants. Parts of the window compare the two to find
/// what is stale.
struct Update {
    ExplorerState& state;  // an update may correct it, for instance if a pixel shows nothing to plot
    const ExplorerState& shown;
    Status& status;
    FrameReport& report;
    bool breakdown = false;  // is the error of the colour needed, although no tab shows it?
};

}  // namespace momentscope::ui
