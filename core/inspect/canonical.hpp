// canonical.hpp -- the canonical representation at a query depth, as the plot draws it.
#pragma once
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// One mass of the distribution that has the biased moments and a mass at the query depth.
struct PointMass {
    float depth;  // power moments: anywhere, +-infinity included. Trigonometric moments: [-1, end of circle)
    float absorbance;  // >= 0
    float value;       // v_l in [0, 1]: the share that counts as in front of the query depth
};

struct CanonicalRepresentation {
    float query = 0;               // depth
    float query_absorbance = 0;    // w_0 b0: the gap between the bounds, of which beta counts
    float in_front = 0;            // absorbance of the others that counts as in front
    std::vector<PointMass> nodes;  // without the query; ascending depth
    int floored_pivots = 0;        // how often the matrix was singular in floats
};

/// Empty nodes for an empty ray or a technique without moments. query in [-1, 1].
CanonicalRepresentation canonical_representation(const Curve& curve, float query);

/// The depth of a node whose place is t in the variable in which the curve's basis finds its roots
/// (shaders/shared/<basis>_moments.glsl). On the circle from -1 to end_of_circle.
float node_depth(float t, float query, const Curve& curve);

/// The depth at which the circle of trigonometric moments ends: beyond 1 lies the wrapping zone (Eq. 5).
float end_of_circle(float wrapping_zone_angle);

}  // namespace momentscope
