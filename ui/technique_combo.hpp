// technique_combo.hpp -- one technique out of the registry.
#pragma once
#include <string>

#include "core/render/transparency.hpp"
#include "core/techniques/technique.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Name and id, as in every list of techniques.
std::string technique_label(const Technique& row);

/// A list to choose from, in which techniques that the GL cannot draw are greyed and say why. `anchor` names
/// it and, followed by an id, its rows.
void draw_technique_combo(const Ui& ui, const std::string& anchor, OrderedAccess access,
                          const std::string& help, const std::string& source, const Technique*& chosen);

}  // namespace momentscope::ui
