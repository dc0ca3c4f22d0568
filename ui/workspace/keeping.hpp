// keeping.hpp -- what is kept for the next start: settings, and the progress of lessons.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// The settings that were kept, for the start of a window; standard ones if there are none or they are
/// damaged, which restore_kept says.
Settings kept_settings(const std::function<std::string(const std::string&)>& kept);

/// Reads what the host has kept. What cannot be read is said in the status line; it is then not kept again,
/// so that nothing is lost.
void restore_kept(Workspace& workspace);

/// Hands changes to the host. Call it once per frame. A host that cannot keep them is named once.
void keep_changes(Workspace& workspace);

}  // namespace momentscope::ui
