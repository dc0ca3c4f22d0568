// panel_list.hpp -- the registry of the tabs below the plot. Tabs, shortcuts and sessions are built from it.
#pragma once
#include <array>
#include <string>

namespace momentscope::ui {

enum class Panel {
#define PANEL(id, name, help) id,
#include "ui/model/panels.def"
#undef PANEL
};

struct PanelRow {
    Panel id;
    const char* key;   // in sessions
    const char* name;  // on the tab
    const char* help;
};

inline constexpr std::array PANELS = {
#define PANEL(id, name, help) PanelRow{Panel::id, #id, name, help},
#include "ui/model/panels.def"
#undef PANEL
};

/// The shortcut that opens the tab with this index.
inline std::string panel_shortcut(std::size_t index) {
    return "Ctrl+" + std::to_string(index + 1);
}

}  // namespace momentscope::ui
