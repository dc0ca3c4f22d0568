// claims.hpp -- what the papers say of their figures, measured of ours.
#pragma once
#include <vector>

#include "core/figures/figure.hpp"

namespace momentscope {

constexpr float TWO_PASSES = 1;  // of ParameterId::moment_passes

/// Sheets of opacity one half, evenly over the depth range but off its ends. count >= 2.
ViewRay even_sheets(int count);

/// Five sheets of different opacities, two of them close together.
ViewRay uneven_sheets();

/// The cloud with shadows of transparent casters: a choice of ParameterId::shadow_technique, with that beta.
Shot shadow_shot(const char* casters, float shadow_weight);

// One for each figure.
std::vector<Finding> measure_overestimation(ShotSource& shots);
std::vector<Finding> measure_ideal(ShotSource& shots);
std::vector<Finding> measure_wrapping(ShotSource& shots);
std::vector<Finding> measure_ship(ShotSource& shots);
std::vector<Finding> measure_teapots(ShotSource& shots);
std::vector<Finding> measure_foliage(ShotSource& shots);
std::vector<Finding> measure_spheres(ShotSource& shots);
std::vector<Finding> measure_eight(ShotSource& shots);
std::vector<Finding> measure_variants(ShotSource& shots);
std::vector<Finding> measure_smoke(ShotSource& shots);
std::vector<Finding> measure_samples(ShotSource& shots);
std::vector<Finding> measure_low(ShotSource& shots);
std::vector<Finding> measure_cloud_shadows(ShotSource& shots);

}  // namespace momentscope
