// selection.hpp -- all changes of what the user looks at: scene, ray, pixel, pins, mark, query depth and
// ranges of the plot. A change also resets what belonged to the previous choice.
#pragma once
#include "ui/model/measurement.hpp"

namespace momentscope::ui {

/// The middle of a pixel as a fraction of the picture. The pixel is first clamped to the picture.
glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size);

/// The picked pixel in a picture of this size.
glm::ivec2 pixel_of(const std::optional<glm::vec2>& fraction, const Scene& scene, glm::ivec2 size);

/// Chooses another scene and resets everything that belonged to the previous one.
void choose_scene(ExplorerState& state, const std::string& id_or_path);

/// Shows a view ray without a scene, instead of the picked pixel's.
void open_ray(ExplorerState& state, ViewRay ray);

/// The same, and opens the ray editor.
void edit_ray(ExplorerState& state, ViewRay ray);

/// Replaces the ray without a scene by a changed version of it.
void change_ray(ExplorerState& state, ViewRay ray);

/// Goes back from a ray without a scene to the scene and its picked pixel.
void leave_ray(ExplorerState& state);

/// Removes the marked fragment from a ray without a scene.
void delete_marked(ExplorerState& state);

/// Picks a pixel and removes the mark of the previous ray.
void pick(ExplorerState& state, glm::vec2 fraction);

/// Picks the pixel that lies this far from the measured one.
void move_pick(ExplorerState& state, const Measurement& measurement, glm::ivec2 by);

/// The first of these pixels behind another one, row by row, that is not next to it; starts over at the end.
/// nullopt if there are none.
std::optional<glm::ivec2> next_place(const std::vector<glm::ivec2>& places, glm::ivec2 from);

/// Pins the picked pixel, or removes its pin. False if there is no room for another pin.
bool toggle_pin(ExplorerState& state, const Measurement& measurement);
void remove_pin(ExplorerState& state, std::size_t index);
void remove_pins(ExplorerState& state);

/// Marks a fragment, to whose depth the query goes. Without a fragment the query stays.
void mark(ExplorerState& state, std::optional<std::size_t> fragment);

/// Marks a fragment, or removes the mark if it is on this fragment.
void toggle_mark(ExplorerState& state, std::size_t fragment);

/// Marks the fragment that is `step` places behind the marked one.
void mark_next(ExplorerState& state, const Measurement& measurement, int step);

/// Does the plot show a ray of the light? This needs a scene with shadows.
bool seen_from_light(const ExplorerState& state);

/// Changes the viewpoint. The receiver of the light is the marked fragment, or else the visible surface. The
/// viewpoints of the light turn shadows on.
void set_viewpoint(ExplorerState& state, Viewpoint viewpoint);

/// Shows the whole ray again, or only all depths, or only all values.
void fit(PlotState& plot);
void fit_depths(PlotState& plot);
void fit_values(PlotState& plot);

/// Changes an axis and fits it, because the old range has another unit.
void set_quantity(PlotState& plot, Quantity quantity);
void set_depth_axis(PlotState& plot, DepthAxis axis);

/// Returns to the scene's own camera.
void reset_camera(ExplorerState& state);

/// Measures only the whole picture again.
void forget_region(CompareState& compare);

/// Closes the card of a lesson.
void close_card(ExplorerState& state);

}  // namespace momentscope::ui
