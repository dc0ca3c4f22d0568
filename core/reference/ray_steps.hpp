// ray_steps.hpp -- the ends of a ray, and depths in the interval between them, in any precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "core/reference/point_masses.hpp"

namespace momentscope::reference {

constexpr int END_STEPS = 65535;  // of the depth range, as in shaders/shared/ends.glsl

/// The ends of a ray in steps of the depth range: near from depth 1 down, far from depth -1 up.
template <class Number>
struct RaySteps {
    Number near = 0, far = 0;
    bool known() const { return near + far >= END_STEPS; }
    Number near_depth() const { return 1 - 2 * near / END_STEPS; }
    Number far_depth() const { return 2 * far / END_STEPS - 1; }
};

/// The step that holds a distance from one side of the depth range.
template <class Number>
Number step_of(const Number& distance) {
    using std::ceil;
    return ceil(distance * END_STEPS / 2);
}

template <class Number>
RaySteps<Number> steps_of_depth(const Number& depth) {
    return {step_of<Number>(1 - depth), step_of<Number>(1 + depth)};
}

template <class Number>
RaySteps<Number> steps_of_masses(std::span<const PointMass<Number>> masses) {
    const Number least = Number(1) / 256;  // fainter fragments do not count
    RaySteps<Number> steps;
    for (const PointMass<Number>& mass : masses) {
        if (mass.absorbance < least) continue;
        const RaySteps<Number> own = steps_of_depth(mass.depth);
        steps.near = std::max(steps.near, own.near);
        steps.far = std::max(steps.far, own.far);
    }
    return steps;
}

/// A depth in the interval between the ends; the depth itself if the ends are not known.
template <class Number>
Number in_interval(const Number& depth, const RaySteps<Number>& steps) {
    if (!steps.known()) return depth;
    const Number width = std::max(Number(steps.near + steps.far - END_STEPS), Number(1));
    const Number from_near = (depth - 1) * END_STEPS / 2 + steps.near;
    return std::clamp(Number(2 * from_near / width - 1), Number(-1), Number(1));
}

}  // namespace momentscope::reference
