// ray_editor.hpp -- the tab for editing a view ray by hand.
#pragma once
#include <optional>

#include "ui/model/measurement.hpp"
#include "ui/model/status.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

struct EditorCanvas;

class RayEditor {
public:
    void draw(const Ui& ui, const Measurement& measurement, ExplorerState& state, Status& status);

private:
    std::optional<ViewRay> edited(const EditorCanvas& canvas, const ViewRay& shown, ExplorerState& state);
    void draw_canvas(const Ui& ui, const Measurement& measurement, ExplorerState& state);
    std::optional<std::size_t> held_;  // the fragment that is being dragged
};

}  // namespace momentscope::ui
