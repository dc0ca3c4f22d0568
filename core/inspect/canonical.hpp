// canonical.hpp -- the canonical representation at a query depth, in the form that the plot draws.
#pragma once
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// One mass of the canonical representation: the distribution with the biased moments and a mass at the query
/// depth.
struct PointMass {
    float depth;       // on the line anywhere, also +-infinity; on the circle in [-1, end_of_circle)
    float absorbance;  // >= 0
    float value;       // v_l in [0, 1]: the share in front of the query depth
};

struct CanonicalRepresentation {
    float query = 0;               // depth
    float query_absorbance = 0;    // w_0 b0: the gap between the bounds
    float in_front = 0;            // absorbance of the nodes that counts as in front
    std::vector<PointMass> nodes;  // without the query; in ascending depth
    int floored_pivots = 0;        // number of pivots raised to the floor
};

/// The canonical representation at a query depth in [-1, 1]. No nodes if the ray is empty or the technique
/// has no moments.
CanonicalRepresentation canonical_representation(const Curve& curve, float query);

/// The depth in the scene of a node at t, the variable in which the basis finds its roots
/// (shaders/shared/<basis>_moments.glsl). query: in the interval of the moments. On the circle the place of
/// the node in that interval lies in [-1, end_of_circle).
float node_depth(float t, float query, const Curve& curve);

/// The depth at which the circle of trigonometric moments ends. The wrapping zone lies between depth 1 and
/// this depth (paper, Eq. 5).
float end_of_circle(float wrapping_zone_angle);

}  // namespace momentscope
