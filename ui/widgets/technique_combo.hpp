// technique_combo.hpp -- a list to choose one technique of the registry.
#pragma once
#include <string>

#include "core/render/transparency.hpp"
#include "core/techniques/technique.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Name and id, as in every list of techniques.
std::string technique_label(const Technique& row);

/// Draws the list. Techniques that the GL cannot draw are greyed out, and their tooltips say why. The anchor
/// of the list is `anchor`; those of its rows add the id of a technique.
void draw_technique_combo(const Ui& ui, const std::string& anchor, const std::string& help,
                          const std::string& source, const Technique*& chosen);

}  // namespace momentscope::ui
