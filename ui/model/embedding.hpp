// embedding.hpp -- the part of the window that a page of somebody else shows.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters/parameters.hpp"
#include "ui/model/panel_list.hpp"

namespace momentscope::ui {

enum class Shown { window, scene, plot, panel };

/// window: everything. Otherwise only the scene, only the plot or only a tab, with the controls of some
/// parameters below it.
struct Embedding {
    Shown shown = Shown::window;
    Panel panel = Panel::controls;  // of Shown::panel
    std::vector<ParameterId> controls;
};

/// part: "" (window), "scene", "plot", or the key of a tab such as "steps". controls: keys of parameters with
/// commas between them. Throws Error that lists what there is.
Embedding parse_embedding(std::string_view part, std::string_view controls);

}  // namespace momentscope::ui
