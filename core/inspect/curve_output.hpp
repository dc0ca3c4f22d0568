// curve_output.hpp -- curves as text.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// The id of a curve's technique, or the text of its configuration where another curve has the same
/// technique.
std::string curve_name(const Curve& curve, const std::vector<Curve>& curves);

/// The form of `inspect --format json`: ray and curves; null where a technique has no such value, never NaN.
std::string curves_to_json(const ViewRay& ray, const std::vector<Curve>& curves);

/// One row per technique and depth, with a header row.
std::string curves_to_csv(const std::vector<Curve>& curves);

/// For reading: aligned columns.
std::string curves_to_table(const ViewRay& ray, const std::vector<Curve>& curves);

}  // namespace momentscope
