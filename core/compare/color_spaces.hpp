// color_spaces.hpp -- converts linear sRGB to colour spaces of human vision.
#pragma once
#include <glm/glm.hpp>

namespace momentscope {

/// Y, Cx, Cz of linear sRGB: the axes of CIELAB without its cube root (Andersson et al. 2020, Section 4.1).
glm::dvec3 opponent_of_linear(const glm::dvec3& rgb);
glm::dvec3 linear_of_opponent(const glm::dvec3& opponent);

/// CIELAB of linear sRGB under D65.
glm::dvec3 lab_of_linear(const glm::dvec3& rgb);

}  // namespace momentscope
