// curve_output.hpp -- curves as text.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// The id of the technique of a curve. If several curves have this technique: the text of the configuration.
std::string curve_name(const Curve& curve, const std::vector<Curve>& curves);

/// Ray and curves as JSON, the output of `inspect --format json`. Values that a technique does not define are
/// null. There is no NaN.
std::string curves_to_json(const ViewRay& ray, const std::vector<Curve>& curves);

/// One row per technique and depth, with a header row.
std::string curves_to_csv(const std::vector<Curve>& curves);

/// A table with aligned columns, for people.
std::string curves_to_table(const ViewRay& ray, const std::vector<Curve>& curves);

}  // namespace momentscope
