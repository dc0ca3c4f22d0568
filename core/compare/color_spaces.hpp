// color_spaces.hpp -- linear sRGB as people see it.
#pragma once
#include <glm/glm.hpp>

namespace momentscope {

/// Y, Cx, Cz: CIELAB's axes without its cube root, of linear sRGB (Andersson et al. 2020, Section 4.1).
glm::dvec3 opponent_of_linear(const glm::dvec3& rgb);
glm::dvec3 linear_of_opponent(const glm::dvec3& opponent);

/// CIELAB of linear sRGB under D65.
glm::dvec3 lab_of_linear(const glm::dvec3& rgb);

}  // namespace momentscope
