// ray_editor.hpp -- the tab for editing a view ray by hand.
#pragma once
#include <optional>
#include <string>

#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Replaces the picked pixel's ray by this ray, without a scene.
void edit_ray(ExplorerState& state, ViewRay ray);

/// Goes back to the scene and its picked pixel.
void leave_ray(ExplorerState& state);

/// Removes the marked fragment from a ray without a scene.
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
