// plot.hpp -- the function behind a pixel, drawn.
#pragma once
#include <imgui.h>

#include "core/inspect/curve.hpp"

namespace momentscope::ui {

/// Where to evaluate a curve so that its drawing misses nothing: evenly, and at and around every fragment's
/// own depth.
std::vector<float> plot_depths(const ViewRay& ray, std::size_t samples);

/// Draws truth, reconstruction, the band between beta = 0 and beta = 1, and the wrapping zone into a
/// rectangle of the current window. The curve's depths ascend.
void draw_plot(const ViewRay& ray, const Curve& curve, ImVec2 upper_left, ImVec2 size);

}  // namespace momentscope::ui
