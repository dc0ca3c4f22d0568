// claims.hpp -- the claims of the papers about their figures, measured with our figures.
#pragma once
#include <vector>

#include "core/figures/figure.hpp"

namespace momentscope {

constexpr float TWO_PASSES = 1;  // of ParameterId::moment_passes

/// Sheets with an opacity of one half, spread evenly over the depth range, but not at its ends. count >= 2.
ViewRay even_sheets(int count);

/// Five sheets of different opacities, two of them close together.
ViewRay uneven_sheets();

/// The cloud with shadows of transparent casters. casters: a choice of ParameterId::shadow_technique.
/// shadow_weight: the beta of the light.
RenderSetup shadow_setup(const char* casters, float shadow_weight);

// One function for each figure.
std::vector<ClaimResult> measure_overestimation(RenderSource& setups);
std::vector<ClaimResult> measure_ideal(RenderSource& setups);
std::vector<ClaimResult> measure_wrapping(RenderSource& setups);
std::vector<ClaimResult> measure_ship(RenderSource& setups);
std::vector<ClaimResult> measure_teapots(RenderSource& setups);
std::vector<ClaimResult> measure_foliage(RenderSource& setups);
std::vector<ClaimResult> measure_spheres(RenderSource& setups);
std::vector<ClaimResult> measure_eight(RenderSource& setups);
std::vector<ClaimResult> measure_variants(RenderSource& setups);
std::vector<ClaimResult> measure_smoke(RenderSource& setups);
std::vector<ClaimResult> measure_samples(RenderSource& setups);
std::vector<ClaimResult> measure_low(RenderSource& setups);
std::vector<ClaimResult> measure_cloud_shadows(RenderSource& setups);

}  // namespace momentscope
