#include "core/compare/color_spaces.hpp"

#include <cmath>

namespace momentscope {

namespace {

// The columns are the XYZ colours of the primaries of sRGB, from their chromaticities and the white point
// D65.
const glm::dmat3 XYZ_OF_LINEAR = [] {
    const auto primary = [](double x, double y) { return glm::dvec3(x / y, 1, (1 - x - y) / y); };
    const glm::dmat3 primaries(primary(0.64, 0.33), primary(0.30, 0.60), primary(0.15, 0.06));
    const glm::dvec3 luminances = glm::inverse(primaries) * primary(0.3127, 0.3290);
    return glm::dmat3(primaries[0] * luminances.x, primaries[1] * luminances.y, primaries[2] * luminances.z);
}();
const glm::dmat3 LINEAR_OF_XYZ = glm::inverse(XYZ_OF_LINEAR);
const glm::dvec3 WHITE = XYZ_OF_LINEAR * glm::dvec3(1);

double lab_curve(double x) {
    constexpr double DELTA = 6.0 / 29;
    return x > DELTA * DELTA * DELTA ? std::cbrt(x) : x / (3 * DELTA * DELTA) + 4.0 / 29;
}

}  // namespace

glm::dvec3 opponent_of_linear(const glm::dvec3& rgb) {
    const glm::dvec3 xyz = XYZ_OF_LINEAR * rgb / WHITE;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::dvec3 linear_of_opponent(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16) / 116;
    return LINEAR_OF_XYZ * (glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * WHITE);
}

glm::dvec3 lab_of_linear(const glm::dvec3& rgb) {
    const glm::dvec3 xyz = XYZ_OF_LINEAR * rgb / WHITE;
    const glm::dvec3 f(lab_curve(xyz.x), lab_curve(xyz.y), lab_curve(xyz.z));
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

}  // namespace momentscope
