// registry_combos.hpp -- combo boxes over the registries of techniques and scenes.
#pragma once
#include <string>

#include "core/techniques/technique.hpp"

namespace momentscope::ui {

/// True when another row was chosen, which is then in the argument.
bool draw_technique_combo(const Technique*& technique);
bool draw_scene_combo(std::string& scene);

}  // namespace momentscope::ui
