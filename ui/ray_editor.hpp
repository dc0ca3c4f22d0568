// ray_editor.hpp -- the tab in which a view ray is made by hand.
#pragma once
#include <optional>
#include <string>

#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Puts a ray of one's own in place of the picked pixel's.
void edit_ray(ExplorerState& state, ViewRay ray);

/// The scene's pixel again.
void leave_ray(ExplorerState& state);

/// Takes the marked fragment out of a ray of one's own.
void delete_marked(ExplorerState& state);

struct EditorCanvas;

class RayEditor {
public:
    void draw(const Ui& ui, const Measurement& measurement, ExplorerState& state, std::string& message);

private:
    std::optional<ViewRay> edited(const EditorCanvas& canvas, const ViewRay& shown, ExplorerState& state);
    void draw_canvas(const Ui& ui, const Measurement& measurement, ExplorerState& state);
    std::optional<std::size_t> held_;  // the fragment that is being dragged
};

}  // namespace momentscope::ui
