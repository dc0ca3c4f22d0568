// link.hpp -- a state as a short text for the address of a page.
#pragma once
#include <string>

#include "ui/model/session.hpp"

namespace momentscope::ui {

/// The session without what a fresh window has anyway, on one line. session_from_json reads it back. Throws
/// Error like require_session_name.
std::string link_text(const ExplorerState& state);

/// The state that an address describes in words, such as "scene=ship&technique=sharp4&beta=0.3": a scene, a
/// technique, a lesson and values of parameters, over `base`. Throws Error that names what there is not.
ExplorerState state_of_words(const std::string& words, ExplorerState base);

}  // namespace momentscope::ui
